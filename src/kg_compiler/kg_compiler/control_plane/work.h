// Effort of an agent to get from a pose to every cell within one window: the
// layers WORK and REACH, and FUSED_VIEW derived from them (A7, A44).
//
//   t(x)       earliest arrival at the centre of x from the departure, through
//              the window's currents [s after departure]
//   budget     min(end - begin, base_travel / V) [s]: no arrival is later
//   REACH      1 where x is open and t(x) <= budget, else 0
//   WORK       t / budget, in [0, 1]; undefined where REACH = 0
//   FUSED_VIEW U REACH (1 - WORK)
//
// WORK uses time instead of the seam cost S because time is the same for every
// policy: apart from hazard and holding station, S is t times a constant.

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
  std::vector<CellAccess> access;  // Per cell.
  kg_base::Raster time_s;          // t; NaN where not reached.

  // WORK of a cell in [0, 1]; nullopt where it is not reached.
  std::optional<double> Share(std::size_t cell) const;
};

// Work from the nearest in time of `places`, departing when the window begins.
// Places on land, forbidden or off the grid reach no cell.
WorkMap ComputeWork(const SeamRules& rules, const WindowRules& window,
                    const WindowWorld& world,
                    const std::vector<kg_base::LonLat>& places);

// FUSED_VIEW of each cell; `tensor` must be the one `work` was computed with.
kg_base::Raster FusedView(const MissionTensor& tensor, const WorkMap& work);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WORK_H_
