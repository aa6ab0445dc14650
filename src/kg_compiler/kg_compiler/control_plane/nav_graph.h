// The control plane, Phi 1, for one agent: the waypoints of every window within
// reach, and the seams between those of consecutive windows, each flown.
//
// The waypoints of window t are sampled from U_t where the agent can be by the
// end of t, starting from a waypoint of window t-1 (or its start) at the begin
// of t, plus the reachable events of the window and the places where it can
// stay. A seam into window t departs when t begins and arrives before it ends.
//
//   S = lambda_time t + lambda_energy E + lambda_risk (H + I)
//       + lambda_unc (1 - w) + lambda_turn T
//   I = isolation_weight t / (1 + n)
//
// with the flight's time t, energy E and hazard H, w the confidence of the
// window of arrival (A55), and n the number of other waypoints of that window
// within half the base travel of the destination, i.e. the alternatives (A20).
// T is the turn from the agent's heading at the start to the course on which an
// edge of the first window leaves it; 0 for all other edges.
//
// Waypoints: the window's events that can be flown to, then picks of Proximal
// Recurrence (within reach, station held until the window ends), at most
// max_waypoints; where fewer than three can be flown to, also the places where
// the agent can stay. Waypoints without an incoming edge are dropped.
//
// In the mode "edges" (A22) a graph also has edges between its own waypoints,
// from each to the kInnerNeighbours nearest others that can be flown to. They
// are flown and priced for a departure at the begin of the window; the true
// departure depends on the preceding edges. Code that chains them must check
// the sum of travel_s within a window against the window's length and
// base_travel_m / cruise_mps, as was done for each single edge, and fly the
// result again from its true departure (kg_selector/paths/walks.h).

#ifndef KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
#define KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_

#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_cost.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/control_plane/waypoint_graph.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

struct SeamCache;

// Builds the graphs of all windows of `rules`, `worlds` in the same order.
// `cache` (may be null) holds the results of the last call, for this agent or
// another, and receives those of this one. Results unaffected by changes are
// reused: whole graphs, and within a window the arrival fields and flights of
// each place; the result is bit-identical to one without cache. Throws
// kg_base::InputError if the agent cannot be anywhere by the end of some window
// (naming it), or starts on land or in a no_go area; the cache is then
// unchanged.
NavGraphs CompileNavGraphs(const SeamRules& rules,
                           const std::vector<WindowWorld>& worlds,
                           SeamCache* cache);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
