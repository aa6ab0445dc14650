// Does a position or a straight segment touch a geometry? Edge by edge with
// GEOS's exact orientation predicate, so that the answer is GEOS's own without
// the graph that its general predicates build for every question.
// Source: ray crossing as in JTS's RayCrossingCounter.

#ifndef KG_BASE_GEO_WKT_LOCATE_H_
#define KG_BASE_GEO_WKT_LOCATE_H_

#include "kg_base/geo/geometry_parts.h"
#include "kg_base/geo/lon_lat.h"

namespace kg_base {

bool Touches(const GeometryParts& parts, LonLat position);
bool Touches(const GeometryParts& parts, LonLat a, LonLat b);
// Every edge against every edge: for small geometries.
bool Touches(const GeometryParts& a, const GeometryParts& b);

}  // namespace kg_base

#endif  // KG_BASE_GEO_WKT_LOCATE_H_
