// What it takes an agent to get from a pose to every cell within one window:
// the layers WORK and REACH, and FUSED_VIEW made of them (A7, A44).
//
//   t(x)       earliest arrival at the centre of x, from the place one departs
//              from, through the window's currents [s after departure]
//   budget     min(end - begin, base_travel / V) [s]: no arrival is later
//   REACH      1 where x is open and t(x) <= budget, else 0
//   WORK       t / budget, in [0, 1]; nothing where REACH = 0
//   FUSED_VIEW U REACH (1 - WORK)
//
// Time, and not the seam cost S, because it is the same for every policy: what
// S has beside hazard and holding station is t times a constant.

#ifndef KG_COMPILER_CONTROL_PLANE_WORK_H_
#define KG_COMPILER_CONTROL_PLANE_WORK_H_

#include <optional>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_base/raster/grid.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/control_plane/waypoint_graph.h"

namespace kg_compiler {

enum class CellAccess : unsigned char {
  kNoData,     // Land, or no currents known.
  kForbidden,  // Closed by a constraint.
  kTooFar,     // Open, but not within the budget.
  kReached,
};

struct WorkMap {
  double budget_s = 0.0;
  std::vector<CellAccess> access;  // By cell.
  kg_base::Raster time_s;          // t; NaN where not reached.

  // WORK of a cell; nothing where it is not reached.
  std::optional<double> Share(std::size_t cell) const;
};

// From the place, or whichever of several is nearest in time, departing when
// the window begins. Places on land, forbidden or off the grid reach nothing.
WorkMap ComputeWork(const SeamRules& rules, const WindowRules& window,
                    const WindowWorld& world,
                    const std::vector<kg_base::LonLat>& places);

// `tensor` is the one of the work's world.
kg_base::Raster FusedView(const MissionTensor& tensor, const WorkMap& work);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WORK_H_
