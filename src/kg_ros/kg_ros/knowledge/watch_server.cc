#include "kg_ros/knowledge/watch_server.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/stopwatch.h"
#include "kg_core/rdf/same_state.h"
#include "kg_core/sparql/results.h"
#include "kg_core/watch/watch_facts.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/state/mission_state.h"
#include "kg_msgs/WatchedAnswer.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/answer_conversion.h"
#include "ros/console.h"

namespace kg_ros {
namespace {

constexpr double kRest_s = 0.1;  // Minimum pause between evaluations.
constexpr unsigned kManyAnswers = 1000;

}  // namespace

WatchServer::WatchServer(const ros::NodeHandle& node,
                         kg_engine::MissionServer* server)
    : server_(server), node_(node), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  for (kg_core::WatchDefinition& watch :
       kg_core::ReadWatches(*server_->Read())) {
    list_.Keep(std::move(watch));
  }
  watched_ =
      node_.advertise<kg_msgs::WatchedAnswer>(kWatchedTopic, kManyAnswers);
  service_ =
      node_.advertiseService(kWatchService, &WatchServer::HandleWatch, this);
  spinner_.start();
  looker_ = std::thread([this] { Run(); });
}

WatchServer::~WatchServer() {
  {
    const std::lock_guard<std::mutex> lock(end_mutex_);
    is_ending_ = true;
  }
  end_changed_.notify_all();
  looker_.join();
  spinner_.stop();
}

bool WatchServer::HandleWatch(kg_msgs::Watch::Request& request,
                              kg_msgs::Watch::Response& response) {
  try {
    if (request.cancel) {
      Cancel(request.id, &response);
    } else {
      Begin({request.id, request.query}, &response);
    }
  } catch (const std::runtime_error& error) {  // InputError, no disk space.
    response.ok = 0;
    response.error = error.what();
  }
  return true;
}

void WatchServer::Cancel(const std::string& id,
                         kg_msgs::Watch::Response* response) {
  const std::lock_guard<std::mutex> lock(list_mutex_);
  response->id = id;
  response->world_version = server_->world_version();
  if (!list_.Cancel(id)) {
    throw kg_base::InputError("there is no watch '" + id + "'");
  }
  server_->KeepWatches(list_.definitions());
  response->ok = 1;
}

void WatchServer::Begin(const kg_core::WatchDefinition& definition,
                        kg_msgs::Watch::Response* response) {
  const std::lock_guard<std::mutex> lock(list_mutex_);
  const auto view = server_->Read();
  const kg_core::WatchedAnswer answer =
      list_.Watch(definition, *view, kg_engine::CurrentDataset(*view));
  server_->KeepWatches(list_.definitions());
  response->id = answer.id;
  response->world_version = answer.world_version;
  response->result = kg_core::ToJson(answer.answer);
  response->error = answer.error;
  response->ok = static_cast<unsigned char>(answer.error.empty());
}

// Re-evaluates after a commit, and only with subscribers: earlier changes are
// reported to the first subscriber. The pause is at least as long as the
// evaluation, so that watching takes at most half a core.
void WatchServer::Run() {
  std::shared_ptr<const kg_core::GraphView> seen;
  double rest_s = 0.0;
  while (RestFor(rest_s)) {
    rest_s = kRest_s;
    if (watched_.getNumSubscribers() == 0) continue;
    if (seen != nullptr && kg_core::IsSameState(*seen, *server_->Read())) {
      continue;
    }
    seen = server_->Read();
    const kg_base::Stopwatch watch;
    LookAtAll();
    rest_s = std::max(kRest_s, watch.Elapsed_s());
  }
}

void WatchServer::LookAtAll() {
  std::vector<std::string> ids;
  {
    const std::lock_guard<std::mutex> lock(list_mutex_);
    ids = list_.ids();
  }
  for (const std::string& id : ids) {
    if (!RestFor(0.0)) return;
    LookAt(id);
  }
}

// Each evaluation uses its own snapshot, taken under the lock, so that no
// answer is older than the previous one.
void WatchServer::LookAt(const std::string& id) {
  const std::lock_guard<std::mutex> lock(list_mutex_);
  const auto view = server_->Read();
  const auto answer = list_.Look(id, *view, kg_engine::CurrentDataset(*view));
  if (!answer) return;
  if (!answer->error.empty()) {
    ROS_WARN_STREAM("[watch] " << id << ": " << answer->error);
  }
  kg_msgs::WatchedAnswer message = ToMessage(*answer);
  message.header.stamp = ros::Time::now();
  watched_.publish(message);
}

bool WatchServer::RestFor(double seconds) {
  std::unique_lock<std::mutex> lock(end_mutex_);
  return !end_changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                                [this] { return is_ending_; });
}

}  // namespace kg_ros
