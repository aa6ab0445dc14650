// Consistency check of an ex:GridSpec, which SHACL Core cannot express.
//
//   ex:rows * ex:pixelSizeKm  =  height of geo:asWKT, to 5 %
//   width of geo:asWKT / ex:cols  =  1/4 to 4 times ex:pixelSizeKm
//
// The cell size is the mean distance between rows. Columns may be narrower or
// wider (ocean models with half as many columns), within the above factor; and
// narrower by any factor where that is due to the latitude alone: steps in
// degrees that agree within the factor. All distances along a row are measured
// at its latitude, so narrow cells are as exact as others.

#ifndef KG_MISSION_MISSION_GRID_CHECK_H_
#define KG_MISSION_MISSION_GRID_CHECK_H_

#include "kg_mission/mission/entity.h"

namespace kg_mission {

// Throws InputError "ex:grid ex:pixelSizeKm: expected ...".
void CheckGrid(const FactEntity& grid);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_GRID_CHECK_H_
