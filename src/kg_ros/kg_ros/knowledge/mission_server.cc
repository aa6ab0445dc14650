#include "kg_ros/knowledge/mission_server.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/base/sha256.h"
#include "kg_core/mission/mission_reader.h"
#include "kg_core/mission/terms.h"
#include "kg_core/mission/vocabulary.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_ros {
namespace {

namespace fs = std::filesystem;
using kg_core::InputError;
using kg_core::Iri;
using kg_core::Transaction;
using kg_core::WorldChange;

constexpr double kLeastShareToPlan = 0.25;  // Of a window's duration.

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
  kg_core::LogVocabulary(
      kg_core::StageVocabulary(folders_.ontology, transaction), Now_s(),
      transaction);
  if (!transaction.empty()) transaction.Commit(WorldChange::kYes);
}

void MissionServer::LoadMission() {
  const std::string path = folders_.mission + "/mission.ttl";
  kg_core::FactUpdate origin;
  origin.id = path;
  origin.author = "mission.ttl";
  origin.files = {{"", path, kg_core::Sha256HexOfFile(path)}};
  Transaction transaction = store_->Begin();
  std::vector<std::string> reasons = kg_core::StageFactsFile(path, transaction);
  if (reasons.empty()) reasons = kg_core::StageIngest(files_, transaction);
  if (!reasons.empty()) throw InputError(JoinLines(reasons));
  mission_ = kg_core::ReadMission(transaction.view());
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
        if (plan_run_ > 0) StageStatus(plan_run_, "stale", &transaction);
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
    if (pose->second.observed) CiteReports(&rules);
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

// Rules that leave from a reported state were made of it, and of the report
// that mission time is.
void MissionServer::CiteReports(kg_compiler::SeamRules* rules) const {
  rules->start_iri = StateNodeOf(rules->agent_id, cycle_).text;
  rules->read_facts.push_back(StateNodeOf(fleet_.Clock(), cycle_).text);
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
  times_.began_s = Now_s();
  const auto compiled =
      compiler_.Compile(mission_, store_->world_version(), FirstWindowToPlan());
  times_.tensors_s = times_.began_s;
  for (const auto& [stage, seconds] : compiled->stage_seconds) {
    if (stage != "rules") times_.tensors_s += seconds;
  }
  ++cycle_;
  auto started = std::make_shared<kg_compiler::Compilation>(*compiled);
  StartFromPoses(started.get());
  CloseVisitedEvents(started.get());
  compilation_ = started;
  times_.ended_s = std::max(Now_s(), times_.tensors_s);
  Transaction transaction = store_->Begin();
  StageCycle(&transaction);
  if (plan_run_ > 0) StageStatus(plan_run_, "stale", &transaction);
  StageSave(plan_run_, &transaction);
  transaction.Commit(WorldChange::kNo);
  return compilation_;
}

void MissionServer::StageCycle(Transaction* transaction) {
  for (const kg_core::Agent& agent : mission_.agents) {
    const auto pose = fleet_.poses().find(agent.id);
    if (pose == fleet_.poses().end() || !pose->second.observed) continue;
    StageReportedState(agent, pose->second, cycle_, transaction);
  }
  StageArtifacts(*compilation_, cycle_, times_, transaction);
}

void MissionServer::Save() {
  Transaction transaction = store_->Begin();
  StageSave(plan_run_, &transaction);
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::StageSave(const std::uint64_t plan_run,
                              Transaction* transaction) {
  MissionState state;
  state.mission_folder = folders_.mission;
  state.cycle = cycle_;
  state.plan_run = plan_run;
  state.mission_time_s = fleet_.time_s();
  state.ended = ended();
  state.poses = fleet_.poses();
  SaveState(state, mission_, *transaction);
}

}  // namespace kg_ros
