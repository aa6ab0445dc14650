#include "kg_compiler/data_plane/masks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "kg_base/raster/wkt_raster.h"
#include "kg_compiler/data_plane/distance_transform.h"

namespace kg_compiler {
namespace {

// Extent without buffer on `extended`.
kg_base::Mask Bare(const WindowRasters& rasters,
                   const ActiveConstraint& constraint,
                   const kg_base::Grid& extended) {
  const kg_mission::Constraint& fact = *constraint.fact;
  if (fact.is_land) return rasters.land;
  if (fact.mask) return FindMask(rasters, constraint, extended);
  if (!fact.area) return kg_base::Mask(extended.size(), 0);
  return kg_base::Rasterise(*fact.area, extended, constraint.effect->cover);
}

// The part of a mask on `extended` that lies on `grid`.
kg_base::Mask Cropped(const kg_base::Mask& mask, const kg_base::Grid& extended,
                      const kg_base::Grid& grid, int margin) {
  kg_base::Mask part;
  part.reserve(grid.size());
  for (int row = 0; row < grid.rows(); ++row) {
    const auto first =
        mask.begin() +
        static_cast<std::ptrdiff_t>(extended.Index({row + margin, margin}));
    part.insert(part.end(), first, first + grid.cols());
  }
  return part;
}

}  // namespace

int BufferMargin(const kg_mission::Constraint& constraint,
                 const kg_base::Grid& grid) {
  if (constraint.is_land || !(constraint.buffer_cells > 0.0)) return 0;
  if (constraint.mask &&
      constraint.mask->resampling == kg_base::Resampling::kNone) {
    return 0;
  }
  // No cell of the grid is farther from another one.
  const double reach =
      std::min<double>(constraint.buffer_cells, grid.rows() + grid.cols());
  return static_cast<int>(std::ceil(reach));
}

const kg_base::Mask& FindMask(const WindowRasters& rasters,
                              const ActiveConstraint& constraint,
                              const kg_base::Grid& extended) {
  const kg_mission::Constraint& fact = *constraint.fact;
  const auto find = [&](const auto& masks) {
    const auto found = masks.find(fact.iri);
    return found == masks.end() ? nullptr : found->second.get();
  };
  const kg_base::Mask* mask = nullptr;
  if (constraint.effect->cover == kg_base::CellCover::kTouched) {
    mask = find(rasters.avoided_masks);
  }
  if (mask == nullptr) mask = find(rasters.constraint_masks);
  if (mask != nullptr && mask->size() == extended.size()) return *mask;
  throw std::logic_error("no mask of the grid's size for " + fact.iri);
}

kg_base::Mask ConstraintExtent(const WindowRasters& rasters,
                               const ActiveConstraint& constraint) {
  const kg_mission::Constraint& fact = *constraint.fact;
  const int margin = BufferMargin(fact, rasters.grid);
  const kg_base::Grid extended = rasters.grid.Extended(margin);
  const kg_base::Mask grown =
      GrowByCells(extended, Bare(rasters, constraint, extended),
                  fact.buffer_cells, fact.buffer_metric);
  return Cropped(grown, extended, rasters.grid, margin);
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
