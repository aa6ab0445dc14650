// Where a cycle, or a what-if, begins from beside the facts: where the agents
// are, how far the mission has come, and what they have done already.

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

// The last plan that was committed, stale or not.
struct PlanInForce {
  std::uint64_t run = 0;  // 0 = there is none.
  PlannedPlaces places;
};

struct StartState {
  FleetState fleet;
  // The stops agents made in windows before the planned ones.
  std::vector<ExecutedVisit> executed;
  PlanInForce in_force{};
  std::uint64_t cycle = 0;  // The one that begins here; names reported states.
};

// A current window with less than a quarter left is not planned any more:
// agents leave for the next one at once.
int FirstWindowToPlan(const StartState& start,
                      const kg_mission::Mission& mission);

// As a store remembers it: where the agents were last heard of, or the start if
// nothing has been planned yet.
StartState StartOf(const kg_core::GraphView& view,
                   const kg_mission::Mission& mission);

// The compilation with rules that leave from where the agents are, with the
// energy they have left, and without what their past visits have closed: an
// event rewards an agent once, and no more agents than it has capacity for.
// Rules of a policy with a churn weight say where the plan in force ends each
// window. So commitments are taken when a cycle begins, for whatever reason;
// a plan that is committed makes nothing dirty.
std::shared_ptr<const kg_compiler::Compilation> StartFrom(
    const StartState& start, const kg_compiler::Compilation& compilation);

// The world of one moment: its facts, where the agents are, and what has been
// compiled of it so far.
struct Present {
  std::shared_ptr<const kg_core::GraphView> facts;
  StartState start;
  kg_compiler::MissionCompiler compiler;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_START_STATE_H_
