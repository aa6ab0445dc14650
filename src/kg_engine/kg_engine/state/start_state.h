// Start state of a cycle or what-if besides facts: the agents' positions,
// mission time, and executed stops.

#ifndef KG_ENGINE_STATE_START_STATE_H_
#define KG_ENGINE_STATE_START_STATE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_engine/state/executed_stops.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_mission/mission/mission.h"

namespace kg_engine {

// The last committed plan, stale or not.
struct PlanInForce {
  std::uint64_t run = 0;  // 0 = none.
  PlannedPlaces places;
};

struct StartState {
  FleetState fleet;
  // Executed stops in windows before the planned ones.
  std::vector<ExecutedVisit> executed;
  PlanInForce in_force{};
  std::uint64_t cycle = 0;  // Cycle that begins here; names reported states.
};

// First window to plan. A current window with less than a quarter left is
// skipped: agents leave for the next one at once.
int FirstWindowToPlan(const StartState& start,
                      const kg_mission::Mission& mission);

// Start state from a store: the agents' last known positions, or the start
// positions if nothing has been planned yet.
StartState StartOf(const kg_core::GraphView& view,
                   const kg_mission::Mission& mission);

// The compilation with rules that start from the agents' current positions,
// with their remaining energy, and without events closed by past visits: an
// event rewards an agent once, and at most as many agents as its capacity.
// Rules of a policy with a churn weight contain the end places of the plan in
// force. So commitments are set when a cycle begins, for any reason; committing
// a plan makes nothing dirty.
std::shared_ptr<const kg_compiler::Compilation> StartFrom(
    const StartState& start, const kg_compiler::Compilation& compilation);

// Snapshot of the world: its facts, start state, and the compiler state so far.
struct Present {
  std::shared_ptr<const kg_core::GraphView> facts;
  StartState start;
  kg_compiler::MissionCompiler compiler;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_START_STATE_H_
