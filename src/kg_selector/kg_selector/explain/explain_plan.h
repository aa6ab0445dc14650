// Why the plan is as it is, and why it is not otherwise: one question, one
// explanation whose contributions sum to what is explained.
//
//   what         value explained
//   ASSIGNMENT   what a step is worth: the waypoint's score + its events'
//   rewards
//                - the seam's cost; without a window, the whole path's
//   TENSOR_CELL  U of Eq. 1
//   EDGE         S, the seam's cost
//   REJECTION    the margin by which the rule was broken [m or agents]
//   WAYPOINT     why not: score of the path chosen - best score of a path by
//   way
//                of it; or what it misses being on a path by
//   EVENT        the same of an event, in one window or (-1) the best of all
//   PLACE        the same of a place that need not be a waypoint
//
// The best path by way of something is exact: the planner's own search with all
// other ways through that window masked, around the same committed paths.

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

// Throws kg_base::InputError if there is nothing of the kind to explain, saying
// what there is.
kg_compiler::Explanation Explain(const PlannedWorld& world,
                                 const PlanQuestion& question);

// As Explain(), by kind. `agent` is of the world.
kg_compiler::Explanation ExplainAssignment(const PlannedWorld& world,
                                           const kg_mission::Agent& agent,
                                           int window);
kg_compiler::Explanation ExplainRejection(const PlannedWorld& world,
                                          std::size_t number);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_EXPLAIN_PLAN_H_
