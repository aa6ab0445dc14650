#include "kg_compiler/traversal/compute_reach.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "kg_compiler/traversal/fan.h"
#include "kg_compiler/traversal/slower_reaches.h"

namespace kg_compiler {
namespace {

constexpr int kSlowerMargin_cells = 4;

// Box that also covers the slower voyages: they stay inside the box of the
// fastest one run until the deadline, except for the neighbourhood that their
// own steps inspect (kSlowerMargin_cells).
CellBox WithSlower(const VoyageRequest& voyage, const CellBox& read) {
  CellBox box = read;
  if (voyage.departure.base_travel_m <
      voyage.motion.cruise_mps *
          (voyage.departure.deadline_s - voyage.departure.time_s)) {
    VoyageRequest unbounded = voyage;
    unbounded.departure.base_travel_m = std::numeric_limits<double>::infinity();
    box = ExtremalFan(unbounded).Run().read;
  }
  const kg_base::Grid& grid = voyage.world.field->grid;
  return {std::max(std::min(box.row, read.row) - kSlowerMargin_cells, 0),
          std::min(std::max(box.row_end, read.row_end) + kSlowerMargin_cells,
                   grid.rows()),
          std::max(std::min(box.col, read.col) - kSlowerMargin_cells, 0),
          std::min(std::max(box.col_end, read.col_end) + kSlowerMargin_cells,
                   grid.cols())};
}

}  // namespace

ReachMap ComputeReach(const VoyageRequest& voyage) {
  if (!IsWellFormed(voyage)) return {};
  ReachMap reach = ExtremalFan(voyage).Run();
  if (voyage.price.per_j > 0.0) {
    reach.slower = std::make_shared<SlowerReaches>();
    reach.read = WithSlower(voyage, reach.read);
  }
  return reach;
}

}  // namespace kg_compiler
