// What the knowledge graph remembers beside facts so that a restart goes on
// where it was: the cycle, the last plan, mission time and the agents' poses.
// Kept in graph ex:graph/state, which does not count as the world.

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

// An empty mission_folder: there is none yet.
MissionState LoadState(const kg_core::GraphView& view);

// Replaces what was there.
void SaveState(const MissionState& state, const kg_mission::Mission& mission,
               kg_core::Transaction& transaction);

// What queries see by default: with the plan that is current in `view`.
kg_core::Dataset CurrentDataset(const kg_core::GraphView& view);

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_MISSION_STATE_H_
