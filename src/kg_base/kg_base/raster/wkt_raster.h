// Rasters of geometries: which cells of a grid an area touches, and which have
// their centre inside.

#ifndef KG_BASE_RASTER_WKT_RASTER_H_
#define KG_BASE_RASTER_WKT_RASTER_H_

#include "kg_base/geo/wkt.h"
#include "kg_base/raster/grid.h"

namespace kg_base {

enum class CellCover {
  kTouched,  // Every cell that the area touches (supercover): the safe side.
  kCentres,  // Cells whose centre lies inside.
};
const char* Name(CellCover cover);  // "touched", "centres".

// The cells that an area covers: 1 = covered.
Mask Rasterise(const Geometry& area, const Grid& grid, CellCover cover);

// Cells that an area touches at all (supercover): for no_go, the safe side.
Mask RasteriseTouched(const Geometry& area, const Grid& grid);
// Cells whose centre lies inside: for soft zones and priors.
Mask RasteriseCentres(const Geometry& area, const Grid& grid);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_WKT_RASTER_H_
