// The knowledge graph's own work, without ROS: holds the store, decides on fact
// updates, compiles cycles, records plans. kg_node converts and publishes.

#ifndef KG_ROS_KNOWLEDGE_MISSION_SERVER_H_
#define KG_ROS_KNOWLEDGE_MISSION_SERVER_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kg_compiler/mission_compiler.h"
#include "kg_core/mission/fact_update.h"
#include "kg_core/mission/ingest.h"
#include "kg_core/mission/mission.h"
#include "kg_core/rdf/store.h"
#include "kg_ros/knowledge/artifact_facts.h"
#include "kg_ros/knowledge/fleet_state.h"
#include "kg_ros/knowledge/mission_state.h"
#include "kg_ros/knowledge/plan_facts.h"

namespace kg_ros {

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

class MissionServer {
 public:
  // Opens the state folder's store, or makes it from the mission folder. A
  // store whose mission has ended is put aside (store-<n>.db) and begun anew.
  // Throws kg_core::InputError; for a store that holds another mission, too.
  explicit MissionServer(MissionFolders folders);

  // One transaction, decided: durable when this returns accepted.
  Decision Apply(const kg_core::FactUpdate& update);
  // What Apply would answer, without doing it.
  std::vector<std::string> Check(const kg_core::FactUpdate& update);

  std::shared_ptr<const kg_core::GraphView> Read() const {
    return store_->Read();
  }
  const kg_core::Mission& mission() const { return mission_; }
  std::uint64_t world_version() const { return store_->world_version(); }
  bool was_restored() const { return was_restored_; }

  FleetState& fleet() { return fleet_; }
  const FleetState& fleet() const { return fleet_; }
  int current_window() const { return fleet_.CurrentWindow(mission_); }
  bool ended() const {
    return current_window() == static_cast<int>(mission_.windows.size());
  }

  // The plan is stale from an accepted change of facts, or the begin of a
  // cycle, until the next one is recorded.

  // Compiles what is dirty for the windows still to be planned and starts the
  // next cycle: rules leave from where the agents are now. A current window
  // with less than a quarter left is not planned any more: agents leave for the
  // next one at once. Throws kg_core::InputError; then no cycle has begun.
  std::shared_ptr<const kg_compiler::Compilation> BeginCycle();
  std::uint64_t cycle() const { return cycle_; }

  // Stores a committed plan and makes it the current one.
  void RecordPlan(PlanRecord record);
  std::uint64_t plan_run() const { return plan_run_; }
  // Adds a waypoint graph to the current plan's facts.
  void RecordNavGraph(const kg_msgs::NavGraph& graph,
                      const std::string& previous_hash);

  // The stops agents made in windows before the planned ones.
  const std::vector<ExecutedVisit>& executed() const { return executed_; }
  void AddExecuted(ExecutedVisit visit);
  // Keeps cycle, time and poses for the next start.
  void Save();
  // All windows are flown: the current plan's stops have been made.
  void RecordEnd();

 private:
  void LoadVocabulary();
  void LoadMission();
  void Restore(const MissionState& state);
  void StageSave(std::uint64_t plan_run, kg_core::Transaction* transaction);
  static void StageStatus(std::uint64_t run, const char* status,
                          kg_core::Transaction* transaction);
  void StageCycle(kg_core::Transaction* transaction);
  void StageGraph(NavGraphOrigin origin,
                  kg_core::Transaction* transaction) const;
  void StageUse(const kg_msgs::NavGraph& graph,
                kg_core::Transaction* transaction) const;
  std::string AgentIri(const std::string& agent_id) const;
  std::vector<std::string> Stage(const kg_core::FactUpdate& update,
                                 kg_core::Transaction& transaction,
                                 Decision* decision);
  int FirstWindowToPlan() const;
  void StartFromPoses(kg_compiler::Compilation* compilation) const;
  void CiteReports(kg_compiler::SeamRules* rules) const;
  void CloseVisitedEvents(kg_compiler::Compilation* compilation) const;
  static void DropOldPlans(std::uint64_t run,
                           kg_core::Transaction* transaction);

  MissionFolders folders_;
  kg_core::FileCache files_;
  std::unique_ptr<kg_core::Store> store_;
  kg_compiler::MissionCompiler compiler_;
  kg_core::Mission mission_;
  FleetState fleet_;
  std::shared_ptr<const kg_compiler::Compilation> compilation_;
  std::vector<ExecutedVisit> executed_;
  CompileTimes times_;  // Of the cycle.
  std::uint64_t cycle_ = 0;
  std::uint64_t plan_run_ = 0;
  bool was_restored_ = false;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_MISSION_SERVER_H_
