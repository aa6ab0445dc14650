#include "kg_ros/knowledge/mission_server.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/mission/expiry.h"
#include "kg_core/mission/mission_reader.h"
#include "kg_core/mission/validator.h"
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

constexpr std::uint64_t kKeptPlans = 5;
constexpr double kLongAgo_s = -std::numeric_limits<double>::infinity();

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
      compiler_(&files_),
      shared_compiler_(compiler_) {
  const MissionState state = LoadState(*store_->Read());
  LoadVocabulary();
  if (state.mission_folder.empty()) {
    LoadMission();
  } else {
    Restore(state);
  }
  next_expiry_s_ = kg_core::NextExpiry_s(*Read(), kLongAgo_s);
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
  start_.fleet.Reset(mission_);
  Save();
}

void MissionServer::Restore(const MissionState& state) {
  if (state.mission_folder != folders_.mission) {
    throw InputError("state folder " + folders_.state + " holds mission " +
                     state.mission_folder + ", not " + folders_.mission +
                     ": choose another with state:=");
  }
  violations_at_start_ = kg_core::Lines(kg_core::Validate(*store_->Read()));
  mission_ = kg_core::ReadMission(*store_->Read());
  start_.fleet.Restore(state.poses, state.mission_time_s);
  start_.fleet.Follow(mission_);
  cycle_ = state.cycle;
  plan_run_ = state.plan_run;
  start_.executed = ReadExecuted(*store_->Read(), plan_run_, mission_);
  was_restored_ = true;
}

Decision MissionServer::Apply(const kg_core::FactUpdate& update) {
  const Stopwatch watch;
  Decision decision;
  Transaction transaction = store_->Begin();
  try {
    kg_core::StagedUpdate staged =
        kg_core::StageUpdateWithFiles(update, files_, transaction);
    decision.reasons = std::move(staged.judgement.reasons);
    decision.ingest_s = staged.ingest_s;
    if (decision.reasons.empty()) {
      kg_core::Mission mission = kg_core::ReadMission(transaction.view());
      if (!transaction.empty()) {
        kg_core::LogUpdate(update, Now_s(), transaction);
        transaction.Commit(WorldChange::kYes);
      }
      mission_ = std::move(mission);
      next_expiry_s_ = kg_core::NextExpiry_s(*Read(), kLongAgo_s);
      const std::lock_guard<std::mutex> lock(mutex_);
      start_.fleet.Follow(mission_);
      decision.accepted = true;
    }
  } catch (const std::runtime_error& error) {  // InputError, or no disk space.
    decision.reasons.push_back(error.what());
  }
  decision.world_version = store_->world_version();
  decision.facts_s = watch.seconds() - decision.ingest_s;
  return decision;
}

Expired MissionServer::Expire() {
  const double now_s = fleet().time_s();
  kg_core::Expiry expiry = kg_core::FindExpired(*Read(), now_s);
  Expired expired;
  expired.update = std::move(expiry.update);
  if (!expired.update.remove.empty()) expired.decision = Apply(expired.update);
  for (std::string& line : expiry.kept) {
    if (told_kept_.insert(line).second) expired.kept.push_back(std::move(line));
  }
  next_expiry_s_ = kg_core::NextExpiry_s(*Read(), now_s);
  return expired;
}

kg_core::Judgement MissionServer::Check(const kg_core::FactUpdate& update) {
  Transaction transaction = store_->Begin();
  try {
    kg_core::Judgement judgement =
        kg_core::StageUpdateWithFiles(update, files_, transaction).judgement;
    if (judgement.reasons.empty()) kg_core::ReadMission(transaction.view());
    return judgement;
  } catch (const InputError& error) {
    return {{error.what()}, std::nullopt};
  }
}

std::shared_ptr<const kg_compiler::Compilation> MissionServer::BeginCycle() {
  const auto compiled = compiler_.Compile(mission_, store_->world_version(),
                                          FirstWindowToPlan(start_, mission_));
  compilation_ = StartFrom(start_, *compiled);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shared_compiler_ = compiler_;
  }
  ++cycle_;
  Save();
  return compilation_;
}

void MissionServer::Save() {
  MissionState state;
  state.mission_folder = folders_.mission;
  state.cycle = cycle_;
  state.plan_run = plan_run_;
  state.mission_time_s = fleet().time_s();
  state.ended = ended();
  state.poses = fleet().poses();
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
  record.executed = start_.executed;
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
  if (std::any_of(executed().begin(), executed().end(), same)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  start_.executed.push_back(std::move(visit));
}

bool MissionServer::Observe(const std::string& agent, const AgentPose& pose) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return start_.fleet.Observe(agent, pose);
}

Present MissionServer::present() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {store_->Read(), start_, shared_compiler_};
}

}  // namespace kg_ros
