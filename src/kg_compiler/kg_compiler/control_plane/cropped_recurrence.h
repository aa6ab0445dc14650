// Proximal Recurrence where only few cells are allowed: on the part of the grid
// that their discs see. Same picks, ties and scores, to the bit, as on the
// whole (proximal_recurrence.h), at the cost of the part.

#ifndef KG_COMPILER_CONTROL_PLANE_CROPPED_RECURRENCE_H_
#define KG_COMPILER_CONTROL_PLANE_CROPPED_RECURRENCE_H_

#include <vector>

#include "kg_compiler/control_plane/proximal_recurrence.h"
#include "kg_compiler/data_plane/cell_box.h"

namespace kg_compiler {

// What the last picks were made from.
struct PickMemo {
  CellBox box;
  kg_base::Raster utility;
  kg_base::Mask allowed;
  RecurrenceOptions options;
  std::vector<RecurrencePick> picks;
};

// `allowed`: cells' indices, ascending. Picks of `memo` are taken over if they
// were made from the same cells of the same grid; else it is made anew.
const std::vector<RecurrencePick>& RecurrenceWithin(
    const kg_base::Grid& grid, const kg_base::Raster& utility,
    const std::vector<int>& allowed, const RecurrenceOptions& options,
    PickMemo* memo);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_CROPPED_RECURRENCE_H_
