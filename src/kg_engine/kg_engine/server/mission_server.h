// The knowledge graph's own work: holds the store, decides on fact updates,
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
  std::string data;      // Where its files are looked up first; may be empty.
  std::string state;     // The durable store's folder; made if missing.
  std::string ontology;  // mission.ttl and shapes.ttl of kg_core.
};

struct Decision {
  bool accepted = false;
  std::vector<std::string> reasons;
  std::uint64_t world_version = 0;
  double facts_s = 0.0;   // Checking and committing.
  double ingest_s = 0.0;  // Reading files, if any were due.
};

// What mission time has outlived.
struct Expired {
  kg_core::FactUpdate update;  // Takes it back; empty: nothing can go.
  Decision decision;
  std::vector<std::string> kept;  // What cannot go and why, each said once.
};

class MissionServer {
 public:
  // Opens the state folder's store, or makes it from the mission folder. A
  // store whose mission has ended is put aside (store-<n>.db) and begun anew.
  // Throws kg_base::InputError; for a store that holds another mission, too.
  explicit MissionServer(MissionFolders folders);

  // One transaction, decided: durable when this returns accepted.
  Decision Apply(const kg_core::FactUpdate& update);
  // What Apply would answer, without doing it; with the violations of shapes
  // that the update would cause.
  kg_mission::UpdateJudgement Check(const kg_core::FactUpdate& update);

  // Has mission time reached the end of some facts' lives? Takes them back, in
  // an update of its own (kg_core/mission/expiry.h).
  bool ExpiryIsDue() const { return fleet().time_s() >= next_expiry_s_; }
  Expired Expire();

  std::shared_ptr<const kg_core::GraphView> Read() const {
    return store_->Read();
  }
  // Keeps them for the next start. From any thread; waits for a transaction
  // that is open.
  void KeepWatches(const std::vector<kg_core::WatchDefinition>& watches);

  const kg_mission::Mission& mission() const { return mission_; }
  std::uint64_t world_version() const { return store_->world_version(); }
  bool was_restored() const { return was_restored_; }
  // What a store that was taken up again holds against the shapes, a line each:
  // shapes may have changed since it was written. The mission goes on; updates
  // are refused only for what they touch.
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

  // Compiles what is dirty for the windows still to be planned and starts the
  // next cycle, from where the agents are now (start_state.h). Throws
  // kg_base::InputError; then no cycle has begun. The plan's facts say that it
  // is stale from an accepted change of facts, or the begin of a cycle, until
  // the next one is recorded.
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

  // What somebody else needs to think ahead from now. Safe from any thread, as
  // are Read() and files().
  Present present() const;
  kg_mission::FileCache* files() { return &files_; }

  // Keeps cycle, time and poses for the next start.
  void Save();
  // All windows are flown: the current plan's stops have been made.
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
  // Changed by one thread only, which reads them freely; guarded for present().
  mutable std::mutex mutex_;
  StartState start_;
  kg_compiler::MissionCompiler shared_compiler_;  // As of the last cycle.
  std::shared_ptr<const kg_compiler::Compilation> compilation_;
  CompileTimes times_;  // Of the cycle.
  std::uint64_t cycle_ = 0;
  RecordedPlans plans_;
  bool was_restored_ = false;
  std::vector<std::string> violations_at_start_;
  double next_expiry_s_ = 0.0;       // Mission time, Unix seconds.
  std::set<std::string> told_kept_;  // Lines of `Expired::kept`.
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_MISSION_SERVER_H_
