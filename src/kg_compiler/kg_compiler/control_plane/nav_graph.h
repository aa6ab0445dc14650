// The control plane, Phi 1, as it runs for one agent: waypoints of every window
// within reach, and the seams between those of consecutive windows, each flown.
//
// Window t's waypoints are sampled from U_t where the agent can be by the end
// of t, having been at one of window t-1's waypoints (or its start) at the
// begin of t, plus the reachable events of the window and the places it can
// stay at. A seam into window t leaves when t begins and arrives before it
// ends.
//
//   S = lambda_time t + lambda_energy E + lambda_risk (H + I)
//       + lambda_unc (1 - w)
//   I = isolation_weight t / (1 + n)
//
// with the flight's time t, energy E and hazard H, w of the window one arrives
// in (A55), and n the other waypoints of that window within half of the base
// travel of the place one goes to: where one could go instead (A20).
//
// Waypoints: the window's events that can be flown to, then picks of Proximal
// Recurrence (within reach, station held until the window ends), at most
// max_waypoints; where fewer than three can be flown to, also the places one
// can stay at. What has no edge into it is left out.
//
// In the mode "edges" (A22) a graph also has edges between its own waypoints,
// from each to the kInnerNeighbours nearest others that can be flown to. They
// are flown and priced as if one left when the window begins: when one really
// gets there differs by the way one came. Whoever strings them together adds
// the travel_s of a window's edges up and holds them against the window's
// length and base_travel_m / cruise_mps, as each single edge has been, and
// flies what is found from its true departure (kg_selector/paths/walks.h).

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
// `cache` (may be null) holds what was made the last time, for this agent or
// another, and what is made now. What of it the changes did not touch is taken
// over: whole graphs, and within a window the arrival fields and flights of
// each place; the result is the same bits as without. Throws
// kg_core::InputError if the agent cannot be anywhere by the end of some window
// (naming it), or starts on land or in a no_go area; then the cache is as it
// was.
NavGraphs CompileNavGraphs(const SeamRules& rules,
                           const std::vector<WindowWorld>& worlds,
                           SeamCache* cache);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
