// State of the knowledge graph besides facts, for resuming after a restart: the
// cycle, the last plan, mission time and the agents' poses. Stored in graph
// ex:graph/state, which is not part of the world.

#ifndef KG_ENGINE_STATE_MISSION_STATE_H_
#define KG_ENGINE_STATE_MISSION_STATE_H_

#include <cstdint>
#include <map>
#include <string>

#include "kg_core/rdf/store.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_mission/mission/mission.h"

namespace kg_engine {

struct MissionState {
  std::string mission_folder;
  std::uint64_t cycle = 0;
  std::uint64_t plan_run = 0;
  double mission_time_s = 0.0;
  bool ended = false;
  std::map<std::string, AgentPose> poses;  // By ex:id.
};

// Loads the state; an empty mission_folder means none is stored.
MissionState LoadState(const kg_core::GraphView& view);

// Replaces the stored state.
void SaveState(const MissionState& state, const kg_mission::Mission& mission,
               kg_core::Transaction& transaction);

// Default dataset of queries, including the current plan of `view`.
kg_core::Dataset CurrentDataset(const kg_core::GraphView& view);

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_MISSION_STATE_H_
