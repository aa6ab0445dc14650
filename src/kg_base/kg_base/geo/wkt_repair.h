// Makes GEOS geometries of parsed well-known text, and invalid areas valid.

#ifndef KG_BASE_GEO_WKT_REPAIR_H_
#define KG_BASE_GEO_WKT_REPAIR_H_

#include "kg_base/geo/geos.h"
#include "kg_base/geo/wkt_parser.h"

namespace kg_base {

// Moves longitudes by a whole turn into [-180, 180]; throws InputError for what
// crosses the antimeridian.
void Canonicalise(WktNode* node);

GeosGeometry Build(const WktNode& node);

// A valid geometry of the same kind of dimension that covers at least what is
// beyond doubt in the invalid one: members that are valid by themselves, and as
// much area as the shell encloses by the even-odd rule less its holes. Throws
// InputError where GEOS's repair falls short of that or leaves no area.
GeosGeometry Repair(const WktNode& node, const GEOSGeometry* invalid);

}  // namespace kg_base

#endif  // KG_BASE_GEO_WKT_REPAIR_H_
