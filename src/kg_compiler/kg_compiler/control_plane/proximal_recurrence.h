// Proximal Recurrence: selects the few places whose sensor footprints cover the
// most utility.
//
// R = U * disc_r (convolution with the sensor's disc in metres, an ellipse in
// cells); take the best allowed cell of R, zero U inside its disc (radius
// `spacing_m`), update R there, repeat. Ties by row, then column. This is
// greedy weighted maximum coverage. Interpretation of Holmberg, Abdelguerfi and
// Ioup, "STROOBnet Optimization via GPU-Accelerated Proximal Recurrence
// Strategies", IEEE BigData 2023, 10.1109/BigData59044.2023.10386774 (A13).
//
// R is summed once for the allowed cells, and after each pick again for cells
// whose disc may cover zeroed ones: the box of radius + spacing around the
// pick. The largest R of every 16 cells of a row, and of every row, is cached.

#ifndef KG_COMPILER_CONTROL_PLANE_PROXIMAL_RECURRENCE_H_
#define KG_COMPILER_CONTROL_PLANE_PROXIMAL_RECURRENCE_H_

#include <vector>

#include "kg_base/raster/grid.h"

namespace kg_compiler {

struct RecurrenceOptions {
  double radius_m = 0.0;   // Sensor footprint: kernel of the convolution.
  double spacing_m = 0.0;  // Picked cells lie farther apart than this.
  int count = 20;
};

struct RecurrencePick {
  kg_base::Cell cell;
  double score = 0.0;  // R when it was picked: sum of U over the disc (A12).
  // Indices of the cells summed in the score, ascending: cells of the disc with
  // non-zero utility that no earlier pick has blanked.
  std::vector<int> footprint;
};

// `utility` >= 0 without NaN; only cells with allowed = 1 and score > 0 are
// picked. Best first. Utilities are quantised to 2^-31 of a power of two above
// the largest one read, so that sums are exact; the box of the allowed cells
// and the cells covered by discs around them are read. Throws std::logic_error
// if sizes do not agree or a radius is not >= 0.
std::vector<RecurrencePick> ProximalRecurrence(
    const kg_base::Grid& grid, const kg_base::Raster& utility,
    const kg_base::Mask& allowed, const RecurrenceOptions& options);

// R at one cell with nothing blanked: the sum of U over the disc around it.
RecurrencePick DiscSum(const kg_base::Grid& grid,
                       const kg_base::Raster& utility, kg_base::Cell cell,
                       double radius_m);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_PROXIMAL_RECURRENCE_H_
