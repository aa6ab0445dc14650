#include "kg_engine/server/mission_server.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "kg_base/common/clock.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/stopwatch.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/update_log.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/watch/watch_facts.h"
#include "kg_mission/mission/expiry.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_vocabulary.h"
#include "kg_mission/mission/validator.h"

namespace kg_engine {
namespace {

namespace fs = std::filesystem;
using kg_base::InputError;
using kg_core::Iri;
using kg_core::Transaction;
using kg_core::WorldChange;

constexpr double kLongAgo_s = -std::numeric_limits<double>::infinity();

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
      compiler_(&files_),
      shared_compiler_(compiler_) {
  const MissionState state = LoadState(*store_->Read());
  LoadVocabulary();
  if (state.mission_folder.empty()) {
    LoadMission();
  } else {
    Restore(state);
  }
  next_expiry_s_ = kg_mission::NextExpiry_s(*Read(), kLongAgo_s);
}

void MissionServer::LoadVocabulary() {
  Transaction transaction = store_->Begin();
  kg_core::LogVocabulary(
      kg_mission::StageVocabulary(folders_.ontology, transaction),
      kg_base::Now_s(), transaction);
  if (!transaction.empty()) transaction.Commit(WorldChange::kYes);
}

void MissionServer::LoadMission() {
  const std::string path = folders_.mission + "/mission.ttl";
  kg_core::FactUpdate origin;
  origin.id = path;
  origin.author = "mission.ttl";
  origin.files = {{"", path, kg_base::Sha256HexOfFile(path)}};
  Transaction transaction = store_->Begin();
  std::vector<std::string> reasons =
      kg_mission::StageFactsFile(path, transaction);
  if (reasons.empty()) reasons = kg_mission::StageIngest(files_, transaction);
  if (!reasons.empty()) throw InputError(kg_base::JoinStrings(reasons, "; "));
  mission_ = kg_mission::ReadMission(transaction.view());
  kg_core::LogUpdate(origin, kg_base::Now_s(), transaction);
  transaction.Commit(WorldChange::kYes);
  start_.fleet.Reset(mission_);
  Save();
}

void MissionServer::Restore(const MissionState& state) {
  if (state.mission_folder != folders_.mission) {
    throw InputError("state folder " + folders_.state + " holds mission " +
                     state.mission_folder + ", not " + folders_.mission +
                     ": choose another with state:=");
  }
  violations_at_start_ = kg_core::Lines(kg_mission::Validate(*store_->Read()));
  mission_ = kg_mission::ReadMission(*store_->Read());
  start_.fleet.Restore(state.poses, state.mission_time_s);
  start_.fleet.Follow(mission_);
  cycle_ = state.cycle;
  plans_.SetRun(state.plan_run);
  start_.executed = ReadExecuted(*store_->Read(), state.plan_run, mission_);
  start_.in_force = {state.plan_run,
                     ReadPlanned(*store_->Read(), state.plan_run, mission_)};
  was_restored_ = true;
}

Decision MissionServer::Apply(const kg_core::FactUpdate& update) {
  const kg_base::Stopwatch watch;
  Decision decision;
  Transaction transaction = store_->Begin();
  try {
    kg_mission::StagedUpdate staged =
        kg_mission::StageUpdateWithFiles(update, files_, transaction);
    decision.reasons = std::move(staged.judgement.reasons);
    decision.ingest_s = staged.ingest_s;
    if (decision.reasons.empty()) {
      kg_mission::Mission mission = kg_mission::ReadMission(transaction.view());
      if (!transaction.empty()) {
        kg_core::LogUpdate(update, kg_base::Now_s(), transaction);
        plans_.StageStale(&transaction);
        transaction.Commit(WorldChange::kYes);
      }
      mission_ = std::move(mission);
      next_expiry_s_ = kg_mission::NextExpiry_s(*Read(), kLongAgo_s);
      const std::lock_guard<std::mutex> lock(mutex_);
      start_.fleet.Follow(mission_);
      decision.accepted = true;
    }
  } catch (const std::runtime_error& error) {  // InputError, or no disk space.
    decision.reasons.push_back(error.what());
  }
  decision.world_version = store_->world_version();
  decision.facts_s = watch.Elapsed_s() - decision.ingest_s;
  return decision;
}

Expired MissionServer::Expire() {
  const double now_s = fleet().time_s();
  kg_mission::ExpiredFacts expiry = kg_mission::FindExpired(*Read(), now_s);
  Expired expired;
  expired.update = std::move(expiry.update);
  if (!expired.update.remove.empty()) expired.decision = Apply(expired.update);
  for (std::string& line : expiry.kept) {
    if (told_kept_.insert(line).second) expired.kept.push_back(std::move(line));
  }
  next_expiry_s_ = kg_mission::NextExpiry_s(*Read(), now_s);
  return expired;
}

kg_mission::UpdateJudgement MissionServer::Check(
    const kg_core::FactUpdate& update) {
  Transaction transaction = store_->Begin();
  try {
    kg_mission::UpdateJudgement judgement =
        kg_mission::StageUpdateWithFiles(update, files_, transaction).judgement;
    if (judgement.reasons.empty()) kg_mission::ReadMission(transaction.view());
    return judgement;
  } catch (const InputError& error) {
    return {{error.what()}, std::nullopt};
  }
}

std::shared_ptr<const kg_compiler::Compilation> MissionServer::BeginCycle() {
  times_.began_s = kg_base::Now_s();
  const auto compiled = compiler_.Compile(mission_, store_->world_version(),
                                          FirstWindowToPlan(start_, mission_));
  // Every stage but "rules" belongs to Phi 2.
  times_.tensors_s = times_.began_s;
  for (const auto& [stage, seconds] : compiled->stage_seconds) {
    if (stage != "rules") times_.tensors_s += seconds;
  }
  ++cycle_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shared_compiler_ = compiler_;
    start_.cycle = cycle_;
  }
  compilation_ = StartFrom(start_, *compiled);
  times_.ended_s = std::max(kg_base::Now_s(), times_.tensors_s);
  Transaction transaction = store_->Begin();
  StageCycle(&transaction);
  plans_.StageStale(&transaction);
  StageSave(plans_.run(), &transaction);
  transaction.Commit(WorldChange::kNo);
  return compilation_;
}

void MissionServer::StageCycle(Transaction* transaction) {
  for (const kg_mission::Agent& agent : mission_.agents) {
    const auto pose = fleet().poses().find(agent.id);
    if (pose == fleet().poses().end() || !pose->second.observed) continue;
    StageReportedState(agent, pose->second, cycle_, transaction);
  }
  for (const kg_compiler::SeamRules& rules : compilation_->rules) {
    const auto is_committed = [](const kg_compiler::WindowRules& window) {
      return window.committed.has_value();
    };
    if (std::any_of(rules.windows.begin(), rules.windows.end(), is_committed)) {
      StageCommitment(start_.in_force.run, rules, transaction);
    }
  }
  StageArtifacts(*compilation_, cycle_, times_, transaction);
}

void MissionServer::Save() {
  Transaction transaction = store_->Begin();
  StageSave(plans_.run(), &transaction);
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::StageSave(const std::uint64_t plan_run,
                              Transaction* transaction) {
  MissionState state;
  state.mission_folder = folders_.mission;
  state.cycle = cycle_;
  state.plan_run = plan_run;
  state.mission_time_s = fleet().time_s();
  state.ended = ended();
  state.poses = fleet().poses();
  SaveState(state, mission_, *transaction);
}

void MissionServer::KeepWatches(
    const std::vector<kg_core::WatchDefinition>& watches) {
  Transaction transaction = store_->Begin();
  kg_core::StageWatches(watches, transaction);
  transaction.Commit(WorldChange::kNo);
}

bool MissionServer::Observe(const std::string& agent, const AgentPose& pose) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return start_.fleet.Observe(agent, pose);
}

RecordedCycle MissionServer::RecordedNow() const {
  return {*compilation_, cycle_, times_.ended_s};
}

void MissionServer::RecordPlan(PlanRecord record) {
  record.executed = start_.executed;
  const std::uint64_t run = record.plan.run;
  Transaction transaction = store_->Begin();
  plans_.StagePlan(record, RecordedNow(), &transaction);
  StageSave(run, &transaction);
  transaction.Commit(WorldChange::kNo);
  plans_.SetRun(run);
  const std::lock_guard<std::mutex> lock(mutex_);
  start_.in_force = {run, ToPlannedPlaces(record.plan)};
}

void MissionServer::RecordGraph(const AgentGraph& graph,
                                const std::string& previous_hash) {
  Transaction transaction = store_->Begin();
  if (!plans_.StageGraph(graph, previous_hash, RecordedNow(), &transaction)) {
    return;
  }
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::RecordEnd() {
  Transaction transaction = store_->Begin();
  plans_.StageEnd(*store_->Read(), &transaction);
  StageSave(plans_.run(), &transaction);
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::AddExecuted(ExecutedVisit visit) {
  const auto same = [&visit](const ExecutedVisit& known) {
    return known.agent == visit.agent &&
           known.visit.window == visit.visit.window;
  };
  if (std::any_of(executed().begin(), executed().end(), same)) return;
  if (plans_.run() > 0) RecallPlan(*store_->Read(), plans_.run(), &visit);
  const std::lock_guard<std::mutex> lock(mutex_);
  start_.executed.push_back(std::move(visit));
}

Present MissionServer::present() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {store_->Read(), start_, shared_compiler_};
}

}  // namespace kg_engine
