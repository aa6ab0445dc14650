// The core of the knowledge graph: holds the store, decides on fact updates,
// compiles cycles, records plans.

#ifndef KG_ENGINE_SERVER_MISSION_SERVER_H_
#define KG_ENGINE_SERVER_MISSION_SERVER_H_

#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/store.h"
#include "kg_core/watch/watch_list.h"
#include "kg_engine/facts/artifact_facts.h"
#include "kg_engine/facts/plan_facts.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_engine/server/recorded_plans.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_engine/state/mission_state.h"
#include "kg_engine/state/start_state.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission.h"
#include "kg_mission/mission/stage_update.h"

namespace kg_engine {

struct MissionFolders {
  std::string mission;   // Holds mission.ttl.
  std::string data;      // Folder searched first for its files; may be empty.
  std::string state;     // The durable store's folder; made if missing.
  std::string ontology;  // mission.ttl and shapes.ttl of kg_mission.
};

struct Decision {
  bool accepted = false;
  std::vector<std::string> reasons;
  std::uint64_t world_version = 0;
  double facts_s = 0.0;   // Checking and committing.
  double ingest_s = 0.0;  // Reading files, if any were due.
};

// Facts that have expired in mission time.
struct Expired {
  kg_core::FactUpdate update;  // Retraction of expired facts; empty = none.
  Decision decision;
  // Facts that cannot be retracted and why, each reported once.
  std::vector<std::string> kept;
};

class MissionServer {
 public:
  // Opens the state folder's store, or creates it from the mission folder. The
  // store of an ended mission is moved aside (store-<n>.db) and a new one is
  // created. Throws kg_base::InputError, also for a store of another mission.
  explicit MissionServer(MissionFolders folders);

  // Decides one transaction; durable when this returns accepted.
  Decision Apply(const kg_core::FactUpdate& update);
  // Result of Apply without applying it, including the shape violations that
  // the update would cause.
  kg_mission::UpdateJudgement Check(const kg_core::FactUpdate& update);

  // Whether mission time has reached the expiry of some facts; Expire()
  // retracts them in an update of its own (kg_mission/mission/expiry.h).
  bool ExpiryIsDue() const { return fleet().time_s() >= next_expiry_s_; }
  Expired Expire();

  std::shared_ptr<const kg_core::GraphView> Read() const {
    return store_->Read();
  }
  // Stores the watches for the next start. May be called from any thread; waits
  // for an open transaction.
  void KeepWatches(const std::vector<kg_core::WatchDefinition>& watches);

  const kg_mission::Mission& mission() const { return mission_; }
  std::uint64_t world_version() const { return store_->world_version(); }
  bool was_restored() const { return was_restored_; }
  // Shape violations of a store resumed at start, one per line: shapes may have
  // changed since it was written. The mission continues; updates are rejected
  // only for violations in facts they touch.
  const std::vector<std::string>& violations_at_start() const {
    return violations_at_start_;
  }

  // False if the agent is unknown or a number is not finite.
  bool Observe(const std::string& agent, const AgentPose& pose);
  const FleetState& fleet() const { return start_.fleet; }
  int current_window() const { return fleet().CurrentWindow(mission_); }
  bool ended() const {
    return current_window() == static_cast<int>(mission_.windows.size());
  }

  // Compiles dirty artifacts for the windows still to be planned and starts the
  // next cycle, from the agents' current positions (start_state.h). Throws
  // kg_base::InputError; then no cycle has begun. The plan is marked stale
  // among the facts from an accepted change of facts, or the begin of a cycle,
  // until the next plan is recorded.
  std::shared_ptr<const kg_compiler::Compilation> BeginCycle();
  std::uint64_t cycle() const { return cycle_; }

  // Stores a committed plan and makes it the current one.
  void RecordPlan(PlanRecord record);
  std::uint64_t plan_run() const { return plans_.run(); }
  // Adds a waypoint graph to the current plan's facts.
  // (RecordedPlans::StageGraph).
  void RecordGraph(const AgentGraph& graph, const std::string& previous_hash);

  const std::vector<ExecutedVisit>& executed() const { return start_.executed; }
  void AddExecuted(ExecutedVisit visit);

  // Snapshot for hypothetical planning from now. Safe from any thread, like
  // Read() and files().
  Present present() const;
  kg_mission::FileCache* files() { return &files_; }

  // Saves cycle, time and poses for the next start.
  void Save();
  // All windows are over: marks the current plan's stops as executed.
  void RecordEnd();

 private:
  void LoadVocabulary();
  void LoadMission();
  void Restore(const MissionState& state);
  void StageSave(std::uint64_t plan_run, kg_core::Transaction* transaction);
  void StageCycle(kg_core::Transaction* transaction);
  RecordedCycle RecordedNow() const;

  MissionFolders folders_;
  kg_mission::FileCache files_;
  std::unique_ptr<kg_core::Store> store_;
  kg_compiler::MissionCompiler compiler_;
  kg_mission::Mission mission_;
  // Written by one thread only, which reads without locking; guarded for
  // present().
  mutable std::mutex mutex_;
  StartState start_;
  kg_compiler::MissionCompiler shared_compiler_;  // Copy as of the last cycle.
  std::shared_ptr<const kg_compiler::Compilation> compilation_;
  CompileTimes times_;  // Times of the current cycle.
  std::uint64_t cycle_ = 0;
  RecordedPlans plans_;
  bool was_restored_ = false;
  std::vector<std::string> violations_at_start_;
  double next_expiry_s_ = 0.0;       // Mission time, Unix seconds.
  std::set<std::string> told_kept_;  // Reported lines of `Expired::kept`.
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_MISSION_SERVER_H_
