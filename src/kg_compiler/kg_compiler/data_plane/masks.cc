#include "kg_compiler/data_plane/masks.h"

#include <algorithm>
#include <stdexcept>

#include "kg_compiler/data_plane/distance_transform.h"
#include "kg_core/raster/wkt_raster.h"

namespace kg_compiler {
namespace {

kg_core::Mask Bare(const WindowRasters& rasters,
                   const ActiveConstraint& constraint) {
  const kg_core::Constraint& fact = *constraint.fact;
  if (fact.is_land) return rasters.land;
  if (fact.mask) {
    const auto mask = rasters.constraint_masks.find(fact.iri);
    if (mask == rasters.constraint_masks.end() ||
        mask->second->size() != rasters.grid.size()) {
      throw std::logic_error("no mask of the grid's size for " + fact.iri);
    }
    return *mask->second;
  }
  if (!fact.area) return kg_core::Mask(rasters.grid.size(), 0);
  return kg_core::Rasterise(*fact.area, rasters.grid, constraint.effect->cover);
}

}  // namespace

kg_core::Mask ConstraintExtent(const WindowRasters& rasters,
                               const ActiveConstraint& constraint) {
  const kg_core::Constraint& fact = *constraint.fact;
  return GrowByCells(rasters.grid, Bare(rasters, constraint), fact.buffer_cells,
                     fact.buffer_metric);
}

kg_core::Mask OpenCells(const WindowRasters& rasters,
                        const std::vector<ActiveConstraint>& constraints) {
  kg_core::Mask open(rasters.grid.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i] = rasters.land[i] ? 0 : 1;
  }
  for (const ActiveConstraint& constraint : constraints) {
    if (!constraint.forbids()) continue;
    const kg_core::Mask closed = ConstraintExtent(rasters, constraint);
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (closed[i]) open[i] = 0;
    }
  }
  return open;
}

std::vector<double> Attenuations(
    const WindowRasters& rasters,
    const std::vector<ActiveConstraint>& constraints,
    kg_core::SoftOverlap overlap) {
  std::vector<double> factor(rasters.grid.size(), 1.0);
  const bool is_product = overlap == kg_core::SoftOverlap::kProduct;
  for (const ActiveConstraint& constraint : constraints) {
    if (constraint.forbids() || constraint.attenuation == 1.0) continue;
    const kg_core::Mask inside = ConstraintExtent(rasters, constraint);
    for (std::size_t i = 0; i < factor.size(); ++i) {
      if (!inside[i]) continue;
      factor[i] = is_product ? factor[i] * constraint.attenuation
                             : std::min(factor[i], constraint.attenuation);
    }
  }
  return factor;
}

}  // namespace kg_compiler
