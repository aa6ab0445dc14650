// Proximal Recurrence for few allowed cells, computed on the part of the grid
// that their discs cover. Picks, ties and scores are bit-identical to those on
// the whole grid (proximal_recurrence.h), at the cost of the part.

#ifndef KG_COMPILER_CONTROL_PLANE_CROPPED_RECURRENCE_H_
#define KG_COMPILER_CONTROL_PLANE_CROPPED_RECURRENCE_H_

#include <vector>

#include "kg_compiler/control_plane/proximal_recurrence.h"
#include "kg_compiler/data_plane/cell_box.h"

namespace kg_compiler {

// Inputs and result of the last call.
struct PickMemo {
  CellBox box;
  kg_base::Raster utility;
  kg_base::Mask allowed;
  RecurrenceOptions options;
  std::vector<RecurrencePick> picks;
};

// `allowed`: cell indices, ascending. The picks in `memo` are reused if they
// were computed from the same cells of the same grid; otherwise `memo` is
// recomputed.
const std::vector<RecurrencePick>& RecurrenceWithin(
    const kg_base::Grid& grid, const kg_base::Raster& utility,
    const std::vector<int>& allowed, const RecurrenceOptions& options,
    PickMemo* memo);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_CROPPED_RECURRENCE_H_
