// The rasters behind the typed references of a mission (mission.h). They share
// their values with the file cache, as far as they are as the file has them.
//
// The mission's grid is that of its work fields, one for all windows. A raster
// on another grid comes to it as its facts declare (ex:resampling) or not at
// all (A54); what lies outside of its own grid is no data.

#ifndef KG_MISSION_MISSION_LAYER_FILES_H_
#define KG_MISSION_MISSION_LAYER_FILES_H_

#include <string>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/shared_raster.h"
#include "kg_base/raster/vector_field.h"
#include "kg_mission/mission/file_cache.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// All throw InputError, also when a file is no longer the one that was
// ingested.

// With the window's fields that cost, on its grid.
kg_base::VectorField LoadWorkField(FileCache& cache, const Mission& mission,
                                   const WorkFieldRef& field);

// A raster on the grid of its file.
struct GriddedRaster {
  kg_base::Grid grid;
  kg_base::SharedRaster values;
};
// |T - T before| for kDifferenceKind, else T itself: the gradient of
// kFrontnessKind is the caller's to take.
GriddedRaster LoadValueLayer(FileCache& cache, const Mission& mission,
                             const ValueLayer& layer);
// Values of a prior, or of a mask.
GriddedRaster LoadRaster(FileCache& cache, const Mission& mission,
                         const RasterRef& ref);

// How a raster on grid `own` comes to `mission_grid`: not at all if both are
// the same, else as declared; kNone if the grids differ and nothing is
// declared, or have no place in common: then InputError, in the name of
// `layer`, with both grids.
void CheckGrids(const std::string& layer, const kg_base::Grid& own,
                const kg_base::Grid& mission_grid,
                kg_base::Resampling declared);
kg_base::SharedRaster OnGrid(const std::string& layer,
                             const GriddedRaster& raster,
                             const kg_base::Grid& mission_grid,
                             kg_base::Resampling declared);

// 1 where a raster is neither 0 nor without data.
kg_base::Mask MakeMask(const kg_base::Raster& values);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_LAYER_FILES_H_
