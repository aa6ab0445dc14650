// Does a position or a straight segment touch a geometry? Tested edge by edge
// with GEOS's exact orientation predicate, which gives the same result as
// GEOS's general predicates without building their topology graph per call.
// Source: ray crossing as in JTS's RayCrossingCounter.

#ifndef KG_BASE_GEO_WKT_LOCATE_H_
#define KG_BASE_GEO_WKT_LOCATE_H_

#include "kg_base/geo/geometry_parts.h"
#include "kg_base/geo/lon_lat.h"

namespace kg_base {

bool Touches(const GeometryParts& parts, LonLat position);
bool Touches(const GeometryParts& parts, LonLat a, LonLat b);
// Tests every pair of edges: for small geometries only.
bool Touches(const GeometryParts& a, const GeometryParts& b);

}  // namespace kg_base

#endif  // KG_BASE_GEO_WKT_LOCATE_H_
