#include "kg_compiler/data_plane/masks.h"

#include "kg_compiler/data_plane/distance_transform.h"

namespace kg_compiler {

kg_core::Mask ConstraintExtent(const kg_core::Grid& grid,
                               const kg_core::Mask& land,
                               const ActiveConstraint& constraint) {
  const kg_core::Constraint& fact = *constraint.fact;
  if (fact.is_land) return GrowByCells(grid, land, fact.buffer_cells);
  if (!fact.area) return kg_core::Mask(grid.size(), 0);
  const kg_core::Mask inside =
      constraint.hard ? kg_core::RasteriseTouched(*fact.area, grid)
                      : kg_core::RasteriseCentres(*fact.area, grid);
  return GrowByCells(grid, inside, fact.buffer_cells);
}

kg_core::Mask OpenCells(const kg_core::Grid& grid, const kg_core::Mask& land,
                        const std::vector<ActiveConstraint>& constraints) {
  kg_core::Mask open(grid.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = land[i] ? 0 : 1;
  for (const ActiveConstraint& constraint : constraints) {
    if (!constraint.hard) continue;
    const kg_core::Mask closed = ConstraintExtent(grid, land, constraint);
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (closed[i]) open[i] = 0;
    }
  }
  return open;
}

std::vector<double> Attenuations(
    const kg_core::Grid& grid, const kg_core::Mask& land,
    const std::vector<ActiveConstraint>& constraints) {
  std::vector<double> factor(grid.size(), 1.0);
  for (const ActiveConstraint& constraint : constraints) {
    if (constraint.hard || constraint.attenuation == 1.0) continue;
    const kg_core::Mask inside = ConstraintExtent(grid, land, constraint);
    for (std::size_t i = 0; i < factor.size(); ++i) {
      if (inside[i]) factor[i] *= constraint.attenuation;
    }
  }
  return factor;
}

}  // namespace kg_compiler
