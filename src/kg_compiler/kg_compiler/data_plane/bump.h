// Gaussian bumps on a grid: events, and the extent of soft edges.

#ifndef KG_COMPILER_DATA_PLANE_BUMP_H_
#define KG_COMPILER_DATA_PLANE_BUMP_H_

#include <functional>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

inline constexpr double kBumpReach_sigmas = 7.0;  // exp(-24.5) = 2e-11 beyond.

// exp(-d^2 / (2 sigma^2)).
double Gaussian(double distance_m, double sigma_m);

// The box and all cells within `reach_m` of it; at least two rows and columns.
CellBox BoxWithin(const kg_base::Grid& grid, const CellBox& box,
                  double reach_m);

// Calls add(cell, bump) for the cells of an event's bump, all in BumpBox().
// Distances by the scale at the middle latitude: within 1e-6 of the geodesic at
// a bump's width.
CellBox BumpBox(const kg_base::Grid& grid, const kg_mission::Event& event);
void ForEachBumpCell(const kg_base::Grid& grid, const kg_mission::Event& event,
                     const std::function<void(kg_base::Cell, double)>& add);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BUMP_H_
