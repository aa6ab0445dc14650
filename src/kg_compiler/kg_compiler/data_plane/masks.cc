#include "kg_compiler/data_plane/masks.h"

#include <algorithm>
#include <stdexcept>

#include "kg_base/raster/wkt_raster.h"
#include "kg_compiler/data_plane/distance_transform.h"

namespace kg_compiler {
namespace {

kg_base::Mask Bare(const WindowRasters& rasters,
                   const ActiveConstraint& constraint) {
  const kg_mission::Constraint& fact = *constraint.fact;
  if (fact.is_land) return rasters.land;
  if (fact.mask) {
    const auto mask = rasters.constraint_masks.find(fact.iri);
    if (mask == rasters.constraint_masks.end() ||
        mask->second->size() != rasters.grid.size()) {
      throw std::logic_error("no mask of the grid's size for " + fact.iri);
    }
    return *mask->second;
  }
  if (!fact.area) return kg_base::Mask(rasters.grid.size(), 0);
  return kg_base::Rasterise(*fact.area, rasters.grid, constraint.effect->cover);
}

}  // namespace

kg_base::Mask ConstraintExtent(const WindowRasters& rasters,
                               const ActiveConstraint& constraint) {
  const kg_mission::Constraint& fact = *constraint.fact;
  return GrowByCells(rasters.grid, Bare(rasters, constraint), fact.buffer_cells,
                     fact.buffer_metric);
}

kg_base::Mask OpenCells(const WindowRasters& rasters,
                        const std::vector<ActiveConstraint>& constraints) {
  kg_base::Mask open(rasters.grid.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i] = rasters.land[i] ? 0 : 1;
  }
  for (const ActiveConstraint& constraint : constraints) {
    if (!constraint.forbids()) continue;
    const kg_base::Mask closed = ConstraintExtent(rasters, constraint);
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (closed[i]) open[i] = 0;
    }
  }
  return open;
}

std::vector<double> Attenuations(
    const WindowRasters& rasters,
    const std::vector<ActiveConstraint>& constraints,
    kg_mission::SoftOverlap overlap) {
  std::vector<double> factor(rasters.grid.size(), 1.0);
  const bool is_product = overlap == kg_mission::SoftOverlap::kProduct;
  for (const ActiveConstraint& constraint : constraints) {
    if (constraint.forbids() || constraint.attenuation == 1.0) continue;
    const kg_base::Mask inside = ConstraintExtent(rasters, constraint);
    for (std::size_t i = 0; i < factor.size(); ++i) {
      if (!inside[i]) continue;
      factor[i] = is_product ? factor[i] * constraint.attenuation
                             : std::min(factor[i], constraint.attenuation);
    }
  }
  return factor;
}

}  // namespace kg_compiler
