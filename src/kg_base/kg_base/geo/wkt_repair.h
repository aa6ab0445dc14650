// Builds GEOS geometries from parsed well-known text, and repairs invalid
// areas.

#ifndef KG_BASE_GEO_WKT_REPAIR_H_
#define KG_BASE_GEO_WKT_REPAIR_H_

#include "kg_base/geo/geos.h"
#include "kg_base/geo/wkt_parser.h"

namespace kg_base {

// Shifts longitudes by a whole turn into [-180, 180]; throws InputError for
// geometries that cross the antimeridian.
void Canonicalise(WktNode* node);

GeosGeometry Build(const WktNode& node);

// A valid geometry of the same dimension that covers at least the unambiguous
// part of the invalid one: members that are valid by themselves, and as much
// area as the shell encloses by the even-odd rule minus its holes. Throws
// InputError if GEOS's repair covers less or leaves no area.
GeosGeometry Repair(const WktNode& node, const GEOSGeometry* invalid);

}  // namespace kg_base

#endif  // KG_BASE_GEO_WKT_REPAIR_H_
