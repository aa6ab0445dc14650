// The rasters behind the typed references of a mission (mission.h). Unmodified
// rasters share their values with the file cache.
//
// The mission's grid is that of its work fields, one for all windows. A raster
// on another grid is resampled as its facts declare (ex:resampling) or rejected
// (A54); points outside its own grid are no data.

#ifndef KG_MISSION_MISSION_LAYER_FILES_H_
#define KG_MISSION_MISSION_LAYER_FILES_H_

#include <string>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/shared_raster.h"
#include "kg_base/raster/vector_field.h"
#include "kg_mission/mission/file_cache.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// All throw InputError, also if a file has changed since it was ingested.

// Loads a work field together with the window's cost fields, on its grid.
kg_base::VectorField LoadWorkField(FileCache& cache, const Mission& mission,
                                   const WorkFieldRef& field);

// A raster with the grid of its file.
struct GriddedRaster {
  kg_base::Grid grid;
  kg_base::SharedRaster values;
};
// |T - T_previous| for kDifferenceKind, else T itself; for kFrontnessKind the
// caller computes the gradient.
GriddedRaster LoadValueLayer(FileCache& cache, const Mission& mission,
                             const ValueLayer& layer);
// Loads the values of a prior or of a mask.
GriddedRaster LoadRaster(FileCache& cache, const Mission& mission,
                         const RasterRef& ref);

// Checks that a raster on grid `own` can be used on `mission_grid`: the grids
// must be the same, or a resampling must be declared and the grids must
// overlap. Otherwise throws InputError that names `layer` and both grids.
void CheckGrids(const std::string& layer, const kg_base::Grid& own,
                const kg_base::Grid& mission_grid,
                kg_base::Resampling declared);
kg_base::SharedRaster OnGrid(const std::string& layer,
                             const GriddedRaster& raster,
                             const kg_base::Grid& mission_grid,
                             kg_base::Resampling declared);

// Mask with 1 where the raster has data and is not 0.
kg_base::Mask MakeMask(const kg_base::Raster& values);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_LAYER_FILES_H_
