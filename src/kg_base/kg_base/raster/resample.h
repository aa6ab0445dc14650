// Resampling of rasters from one grid to another.

#ifndef KG_BASE_RASTER_RESAMPLE_H_
#define KG_BASE_RASTER_RESAMPLE_H_

#include "kg_base/raster/grid.h"

namespace kg_base {

// Resampling method; kNone: no resampling. kTouched is not chosen by facts: it
// is how masks of forbidden places are resampled.
enum class Resampling { kNone, kBilinear, kNearest, kTouched };

// At each centre of `to` the bilinear mean of the four centres around it; the
// nearest one's value where one of the four is NaN, NaN where the nearest is
// NaN and outside of `from` (its edges, half a cell beyond the outer centres).
Raster ResampleBilinear(const Grid& from, const Raster& values, const Grid& to);

// At each centre of `to` the value of the cell of `from` that contains it, NaN
// outside. Values are preserved, so masks stay masks.
Raster ResampleNearest(const Grid& from, const Raster& values, const Grid& to);

// In each cell of `to` the value of largest magnitude of the cells of `from`
// that overlap it; NaN where none of them has data. A mask stays a mask that
// covers at least what it covered before, however fine its cells. An overlap of
// less than 1 % of the smaller cell counts as none: file coordinates carry
// float32 noise.
Raster ResampleTouched(const Grid& from, const Raster& values, const Grid& to);

// Resamples by the given method. Throws std::logic_error for kNone.
Raster Resample(const Grid& from, const Raster& values, const Grid& to,
                Resampling how);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_RESAMPLE_H_
