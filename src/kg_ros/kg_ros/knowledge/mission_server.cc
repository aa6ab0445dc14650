#include "kg_ros/knowledge/mission_server.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/mission/mission_reader.h"
#include "kg_core/mission/vocabulary.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/watch/watch_facts.h"

namespace kg_ros {
namespace {

namespace fs = std::filesystem;
using kg_core::InputError;
using kg_core::Iri;
using kg_core::Literal;
using kg_core::Term;
using kg_core::Transaction;
using kg_core::WorldChange;

constexpr double kLeastShareToPlan = 0.25;  // Of a window's duration.
constexpr std::uint64_t kKeptPlans = 5;

double Now_s() {
  return std::chrono::duration<double>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         begin_)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ =
      std::chrono::steady_clock::now();
};

std::string JoinLines(const std::vector<std::string>& lines) {
  std::string joined;
  for (const std::string& line : lines) {
    if (!joined.empty()) joined += "; ";
    joined += line;
  }
  return joined;
}

std::string StorePath(const std::string& state_folder) {
  return state_folder + "/store.db";
}

void MakeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw InputError("state folder " + folder +
                     " cannot be made: " + error.message());
  }
}

// Moves a finished mission's store out of the way: store-1.db, store-2.db, ...
void PutAside(const std::string& state_folder) {
  const std::string store = StorePath(state_folder);
  int number = 1;
  const auto aside = [&](const std::string& suffix) {
    return state_folder + "/store-" + std::to_string(number) + ".db" + suffix;
  };
  while (fs::exists(aside(""))) ++number;
  for (const char* suffix : {"", "-wal", "-shm"}) {
    if (fs::exists(store + suffix)) fs::rename(store + suffix, aside(suffix));
  }
}

std::unique_ptr<kg_core::Store> OpenStore(const std::string& state_folder) {
  MakeFolder(state_folder);
  auto store = std::make_unique<kg_core::Store>(StorePath(state_folder));
  if (!LoadState(*store->Read()).ended) return store;
  store.reset();
  PutAside(state_folder);
  return std::make_unique<kg_core::Store>(StorePath(state_folder));
}

}  // namespace

MissionServer::MissionServer(MissionFolders folders)
    : folders_(std::move(folders)),
      files_(folders_.mission, folders_.data),
      store_(OpenStore(folders_.state)),
      compiler_(&files_) {
  const MissionState state = LoadState(*store_->Read());
  LoadVocabulary();
  if (state.mission_folder.empty()) {
    LoadMission();
  } else {
    Restore(state);
  }
}

void MissionServer::LoadVocabulary() {
  Transaction transaction = store_->Begin();
  kg_core::StageVocabulary(folders_.ontology, transaction);
  if (!transaction.empty()) transaction.Commit(WorldChange::kYes);
}

void MissionServer::LoadMission() {
  const std::string path = folders_.mission + "/mission.ttl";
  Transaction transaction = store_->Begin();
  std::vector<std::string> reasons = kg_core::StageFactsFile(path, transaction);
  if (reasons.empty()) reasons = kg_core::StageIngest(files_, transaction);
  if (!reasons.empty()) throw InputError(JoinLines(reasons));
  mission_ = kg_core::ReadMission(transaction.view());
  kg_core::FactUpdate origin;
  origin.id = path;
  origin.author = "mission.ttl";
  kg_core::LogUpdate(origin, Now_s(), transaction);
  transaction.Commit(WorldChange::kYes);
  fleet_.Reset(mission_);
  Save();
}

void MissionServer::Restore(const MissionState& state) {
  if (state.mission_folder != folders_.mission) {
    throw InputError("state folder " + folders_.state + " holds mission " +
                     state.mission_folder + ", not " + folders_.mission +
                     ": choose another with state:=");
  }
  mission_ = kg_core::ReadMission(*store_->Read());
  fleet_.Restore(state.poses, state.mission_time_s);
  fleet_.Follow(mission_);
  cycle_ = state.cycle;
  plan_run_ = state.plan_run;
  executed_ = ReadExecuted(*store_->Read(), plan_run_, mission_);
  was_restored_ = true;
}

std::vector<std::string> MissionServer::Stage(const kg_core::FactUpdate& update,
                                              Transaction& transaction,
                                              Decision* decision) {
  std::vector<std::string> reasons = kg_core::StageUpdate(update, transaction);
  if (reasons.empty() && kg_core::IngestIsDue(transaction)) {
    const Stopwatch watch;
    reasons = kg_core::StageIngest(files_, transaction);
    decision->ingest_s = watch.seconds();
  }
  return reasons;
}

Decision MissionServer::Apply(const kg_core::FactUpdate& update) {
  const Stopwatch watch;
  Decision decision;
  Transaction transaction = store_->Begin();
  try {
    decision.reasons = Stage(update, transaction, &decision);
    if (decision.reasons.empty()) {
      kg_core::Mission mission = kg_core::ReadMission(transaction.view());
      if (!transaction.empty()) {
        kg_core::LogUpdate(update, Now_s(), transaction);
        transaction.Commit(WorldChange::kYes);
      }
      mission_ = std::move(mission);
      fleet_.Follow(mission_);
      decision.accepted = true;
    }
  } catch (const std::runtime_error& error) {  // InputError, or no disk space.
    decision.reasons.push_back(error.what());
  }
  decision.world_version = store_->world_version();
  decision.facts_s = watch.seconds() - decision.ingest_s;
  return decision;
}

std::vector<std::string> MissionServer::Check(
    const kg_core::FactUpdate& update) {
  Decision decision;
  Transaction transaction = store_->Begin();
  try {
    std::vector<std::string> reasons = Stage(update, transaction, &decision);
    if (reasons.empty()) kg_core::ReadMission(transaction.view());
    return reasons;
  } catch (const InputError& error) {
    return {error.what()};
  }
}

int MissionServer::FirstWindowToPlan() const {
  const int current = current_window();
  const int count = static_cast<int>(mission_.windows.size());
  if (current + 1 >= count) return current;
  const kg_core::TimeWindow& window = mission_.windows[current];
  const double left_s = window.end_s - fleet_.time_s();
  const bool worth_it = left_s >= kLeastShareToPlan * window.duration_s();
  return worth_it ? current : current + 1;
}

void MissionServer::StartFromPoses(
    kg_compiler::Compilation* compilation) const {
  for (kg_compiler::SeamRules& rules : compilation->rules) {
    const auto pose = fleet_.poses().find(rules.agent_id);
    if (pose == fleet_.poses().end() || rules.windows.empty()) continue;
    rules.start = pose->second.position;
    rules.start_heading_rad = pose->second.heading_rad;
    if (!std::isnan(pose->second.energy_left_j)) {
      rules.energy_budget_j = std::max(0.0, pose->second.energy_left_j);
    }
    kg_compiler::WindowRules& first = rules.windows.front();
    const double duration_s = first.end_s - first.begin_s;
    first.begin_s = fleet_.time_s();
    first.base_travel_m *= (first.end_s - first.begin_s) / duration_s;
  }
}

// An event rewards an agent once, and no more agents than it has capacity for;
// visits that have been made count.
void MissionServer::CloseVisitedEvents(
    kg_compiler::Compilation* compilation) const {
  std::map<std::string, std::set<std::string>> visitors;  // By event.
  for (const ExecutedVisit& past : executed_) {
    for (const std::string& event : past.visit.events) {
      visitors[event].insert(past.agent_iri);
    }
  }
  std::map<std::string, int>& capacity =
      compilation->coordination.event_capacity;
  for (const auto& [event, agents] : visitors) {
    const auto left = capacity.find(event);
    if (left == capacity.end()) continue;
    left->second = std::max(0, left->second - static_cast<int>(agents.size()));
  }
  for (kg_compiler::SeamRules& rules : compilation->rules) {
    const auto is_closed = [&](const kg_compiler::EventRule& event) {
      const auto left = capacity.find(event.iri);
      return visitors[event.iri].count(rules.agent_iri) > 0 ||
             (left != capacity.end() && left->second == 0);
    };
    for (kg_compiler::WindowRules& window : rules.windows) {
      auto& events = window.events;
      events.erase(std::remove_if(events.begin(), events.end(), is_closed),
                   events.end());
    }
  }
}

std::shared_ptr<const kg_compiler::Compilation> MissionServer::BeginCycle() {
  const auto compiled =
      compiler_.Compile(mission_, store_->world_version(), FirstWindowToPlan());
  auto started = std::make_shared<kg_compiler::Compilation>(*compiled);
  StartFromPoses(started.get());
  CloseVisitedEvents(started.get());
  compilation_ = started;
  ++cycle_;
  Save();
  return compilation_;
}

void MissionServer::Save() {
  MissionState state;
  state.mission_folder = folders_.mission;
  state.cycle = cycle_;
  state.plan_run = plan_run_;
  state.mission_time_s = fleet_.time_s();
  state.ended = ended();
  state.poses = fleet_.poses();
  Transaction transaction = store_->Begin();
  SaveState(state, mission_, transaction);
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::KeepWatches(
    const std::vector<kg_core::WatchDefinition>& watches) {
  Transaction transaction = store_->Begin();
  kg_core::StageWatches(watches, transaction);
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::RecordPlan(PlanRecord record) {
  record.executed = executed_;
  plan_run_ = record.assignments.plan_run;
  Transaction transaction = store_->Begin();
  for (const kg_core::Statement& statement :
       PlanStatements(record, *compilation_)) {
    transaction.Add(statement);
  }
  DropOldPlans(&transaction);
  transaction.Commit(WorldChange::kNo);
  Save();
}

void MissionServer::DropOldPlans(Transaction* transaction) const {
  if (plan_run_ <= kKeptPlans) return;
  transaction->RemoveMatching(nullptr, nullptr, nullptr,
                              PlanGraph(plan_run_ - kKeptPlans));
}

void MissionServer::RecordNavGraph(const kg_msgs::NavGraph& graph,
                                   const std::string& previous_hash) {
  NavGraphPlace place;
  place.run = plan_run_;
  place.previous_hash = previous_hash;
  for (const kg_core::TimeWindow& window : mission_.windows) {
    if (window.index == graph.window) place.window_iri = window.iri;
  }
  const kg_core::Agent* agent = mission_.FindAgent(graph.agent_iri);
  if (agent == nullptr || place.window_iri.empty()) return;
  place.start_iri = agent->start_iri;
  Transaction transaction = store_->Begin();
  for (const kg_core::Statement& statement : NavGraphStatements(graph, place)) {
    transaction.Add(statement);
  }
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::MarkPlanStale() {
  if (plan_run_ == 0) return;
  const Term run = PlanRunNode(plan_run_);
  const Term status = Iri(std::string(kg_core::kEx) + "status");
  const Term graph = PlanGraph(plan_run_);
  Transaction transaction = store_->Begin();
  transaction.RemoveMatching(&run, &status, nullptr, graph);
  transaction.Add({run, status, Literal("stale"), graph});
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::RecordEnd() {
  const Term planned = Literal("planned");
  const Term status = Iri(std::string(kg_core::kEx) + "status");
  const Term graph = PlanGraph(plan_run_);
  Transaction transaction = store_->Begin();
  for (const Term& stop :
       kg_core::Subjects(*store_->Read(), graph.text, status, planned)) {
    transaction.Remove({stop, status, planned, graph});
    transaction.Add({stop, status, Literal("executed"), graph});
  }
  transaction.Commit(WorldChange::kNo);
  Save();
}

void MissionServer::AddExecuted(ExecutedVisit visit) {
  const auto same = [&visit](const ExecutedVisit& known) {
    return known.agent == visit.agent &&
           known.visit.window == visit.visit.window;
  };
  if (std::none_of(executed_.begin(), executed_.end(), same)) {
    executed_.push_back(std::move(visit));
  }
}

}  // namespace kg_ros
