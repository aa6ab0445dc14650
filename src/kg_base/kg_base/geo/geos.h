// Wrapper of GEOS: its reentrant C interface with one context per thread, owned
// geometries, and errors as exceptions.

#ifndef KG_BASE_GEO_GEOS_H_
#define KG_BASE_GEO_GEOS_H_

#include <geos_c.h>

#include <memory>
#include <vector>

#include "kg_base/geo/lon_lat.h"

namespace kg_base {

// The calling thread's context. GEOS's last message in it is in GeosMessage.
GEOSContextHandle_t Geos();

struct GeosDeleter {
  void operator()(GEOSGeometry* geometry) const;  // From any thread.
};
using GeosGeometry = std::unique_ptr<GEOSGeometry, GeosDeleter>;

// Owns what GEOS returned; throws InputError with GEOS's message for null.
GeosGeometry Owned(GEOSGeometry* result);
// GEOS's answer 0 or 1; throws InputError with its message for 2.
bool Answer(char result);

GeosGeometry GeosPoint(LonLat position);
GeosGeometry GeosLine(const std::vector<LonLat>& chain);
// Closed rings, shell first.
GeosGeometry GeosPolygon(const std::vector<std::vector<LonLat>>& rings);
double GeosArea(const GEOSGeometry* geometry);

}  // namespace kg_base

#endif  // KG_BASE_GEO_GEOS_H_
