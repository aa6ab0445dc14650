// Rasterisation of geometries: cells of a grid that an area touches, and cells
// whose centre is inside.

#ifndef KG_BASE_RASTER_WKT_RASTER_H_
#define KG_BASE_RASTER_WKT_RASTER_H_

#include "kg_base/geo/wkt.h"
#include "kg_base/raster/grid.h"

namespace kg_base {

enum class CellCover {
  kTouched,  // Every cell that the area touches (supercover): conservative.
  kCentres,  // Cells whose centre lies inside.
};
const char* Name(CellCover cover);  // "touched", "centres".

// The cells that an area covers: 1 = covered.
Mask Rasterise(const Geometry& area, const Grid& grid, CellCover cover);

// Cells that an area touches (supercover): conservative, for no_go areas.
Mask RasteriseTouched(const Geometry& area, const Grid& grid);
// Cells whose centre lies inside: for soft zones and priors.
Mask RasteriseCentres(const Geometry& area, const Grid& grid);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_WKT_RASTER_H_
