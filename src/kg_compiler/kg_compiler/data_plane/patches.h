// Rasters that are 0 outside a box of cells: constraints, areas of priors and
// events on a grid. The cost of an area is that of its box, not of the grid.
//
// The key of a patch covers all its inputs except the grid and the land: equal
// keys on the same grid and land mean equal patches.

#ifndef KG_COMPILER_DATA_PLANE_PATCHES_H_
#define KG_COMPILER_DATA_PLANE_PATCHES_H_

#include <cstddef>
#include <memory>
#include <string>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/window_rasters.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

struct MaskPatch {
  std::string key;
  CellBox box;
  kg_base::Mask inside;  // Cells of the box, row-major: 1 = inside.

  // Row of the mask; [0] is the first column of the box.
  const unsigned char* Row(int row) const {
    return inside.data() + static_cast<std::size_t>(row - box.row) * box.cols();
  }
};

struct ValuePatch {
  std::string key;
  CellBox box;
  // Values of the box, row-major. NaN = no data, counts as 0.
  std::shared_ptr<const kg_base::Raster> values;

  const float* Row(int row) const {
    return values->data() +
           static_cast<std::size_t>(row - box.row) * box.cols();
  }
};

// The extent of a constraint, including its buffer; masks.h is the counterpart
// for whole grids.
std::string ConstraintKey(const kg_mission::Mission& mission,
                          const ActiveConstraint& constraint);
MaskPatch ConstraintPatch(const WindowRasters& rasters,
                          const ActiveConstraint& constraint, std::string key);

// A prior in [0, 1] (its soft edge ends at 7 sigma, where it is 2e-11), or its
// raster unchanged.
std::string PriorKey(const kg_mission::Mission& mission,
                     const kg_mission::PriorLayer& prior);
ValuePatch PriorPatch(const WindowRasters& rasters,
                      const kg_mission::PriorLayer& prior, std::string key);

// An event's bump: exp(-d^2 / (2 radius^2)), to 7 sigma.
std::string BumpKey(const kg_mission::Event& event);
ValuePatch BumpPatch(const kg_base::Grid& grid, const kg_mission::Event& event,
                     std::string key);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_PATCHES_H_
