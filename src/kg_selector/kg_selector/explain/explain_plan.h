// Explains a plan: why a decision was taken, or why an alternative was not.
// Each question has one explanation, whose contributions sum to the explained
// value.
//
//   what         value explained
//   ASSIGNMENT   value of a step: the waypoint's score + its events' rewards
//                - the seam's cost; without a window, that of the whole path
//   TENSOR_CELL  U of Eq. 1
//   EDGE         S, the seam's cost
//   REJECTION    margin by which the rule was broken [m or agents]
//   WAYPOINT     why not: score of the path chosen - best score of a path
//                through it; or the margin that excludes it (why_not.h)
//   EVENT        as WAYPOINT, for an event in one window, or (-1) in the best
//   PLACE        as WAYPOINT, for any place
//
// The best path through a waypoint is exact: the planner's own search with all
// other nodes of that window masked, around the same committed paths.

#ifndef KG_SELECTOR_EXPLAIN_EXPLAIN_PLAN_H_
#define KG_SELECTOR_EXPLAIN_EXPLAIN_PLAN_H_

#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/explain/explanation.h"
#include "kg_selector/explain/planned_world.h"

namespace kg_selector {

enum class QuestionKind {
  kAssignment,
  kTensorCell,
  kEdge,
  kRejection,
  kWaypoint,
  kEvent,
  kPlace
};

struct PlanQuestion {
  QuestionKind what = QuestionKind::kAssignment;
  std::string agent;  // ex:id or IRI. Unused for rejections.
  int window = -1;
  int from = 0;           // kEdge.
  int to = 0;             // kEdge, kWaypoint.
  std::vector<int> via;   // kEdge: waypoints visited on the way.
  kg_base::LonLat place;  // kTensorCell, kPlace.
  std::string id;  // kEvent: IRI or "ex:seep". kRejection: its number or IRI.
};

// Throws kg_base::InputError, listing the valid choices, if the question names
// nothing that can be explained.
kg_compiler::Explanation Explain(const PlannedWorld& world,
                                 const PlanQuestion& question);

// Explain() for one kind each. `agent` belongs to `world`.
kg_compiler::Explanation ExplainAssignment(const PlannedWorld& world,
                                           const kg_mission::Agent& agent,
                                           int window);
kg_compiler::Explanation ExplainRejection(const PlannedWorld& world,
                                          std::size_t number);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_EXPLAIN_PLAN_H_
