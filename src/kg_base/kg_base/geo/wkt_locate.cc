#include "kg_base/geo/wkt_locate.h"

#include <algorithm>

#include "kg_base/geo/geos.h"

namespace kg_base {
namespace {

using Chain = GeometryParts::Chain;

// 1: p lies left of the line from a to b, -1: right, 0: on the line.
int Side(GEOSContextHandle_t geos, LonLat a, LonLat b, LonLat p) {
  return GEOSOrientationIndex_r(geos, a.lon_deg, a.lat_deg, b.lon_deg,
                                b.lat_deg, p.lon_deg, p.lat_deg);
}

bool RangesMeet(double a, double b, double c, double d) {
  return std::max(a, b) >= std::min(c, d) && std::min(a, b) <= std::max(c, d);
}

bool SegmentsMeet(GEOSContextHandle_t geos, LonLat a, LonLat b, LonLat c,
                  LonLat d) {
  if (!RangesMeet(a.lon_deg, b.lon_deg, c.lon_deg, d.lon_deg) ||
      !RangesMeet(a.lat_deg, b.lat_deg, c.lat_deg, d.lat_deg)) {
    return false;
  }
  return Side(geos, a, b, c) * Side(geos, a, b, d) <= 0 &&
         Side(geos, c, d, a) * Side(geos, c, d, b) <= 0;
}

bool ChainMeets(const Chain& chain, LonLat a, LonLat b) {
  const GEOSContextHandle_t geos = Geos();
  if (chain.size() == 1) return SegmentsMeet(geos, chain[0], chain[0], a, b);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (SegmentsMeet(geos, chain[i - 1], chain[i], a, b)) return true;
  }
  return false;
}

// Even-odd test by the edges that a ray to the east crosses, with the half-open
// rule. The boundary is tested separately.
bool IsInside(const std::vector<Chain>& polygon, LonLat p) {
  const GEOSContextHandle_t geos = Geos();
  bool inside = false;
  for (const Chain& ring : polygon) {
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const LonLat a = ring[i - 1];
      const LonLat b = ring[i];
      if ((a.lat_deg > p.lat_deg) == (b.lat_deg > p.lat_deg)) continue;
      const int side = Side(geos, a, b, p);
      if (side == (b.lat_deg > a.lat_deg ? 1 : -1)) inside = !inside;
    }
  }
  return inside;
}

std::vector<Chain> Chains(const GeometryParts& parts) {
  std::vector<Chain> chains = parts.lines;
  for (const std::vector<Chain>& polygon : parts.polygons) {
    chains.insert(chains.end(), polygon.begin(), polygon.end());
  }
  return chains;
}

bool AnyEdgeTouches(const GeometryParts& parts, const Chain& chain) {
  if (Touches(parts, chain.front())) return true;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (Touches(parts, chain[i - 1], chain[i])) return true;
  }
  return false;
}

}  // namespace

// True if an edge of one touches the other, or one lies entirely inside the
// other.
bool Touches(const GeometryParts& a, const GeometryParts& b) {
  for (const Chain& chain : Chains(b)) {
    if (AnyEdgeTouches(a, chain)) return true;
  }
  for (const Chain& chain : Chains(a)) {
    if (Touches(b, chain.front())) return true;
  }
  return false;
}

bool Touches(const GeometryParts& parts, LonLat position) {
  return Touches(parts, position, position);
}

bool Touches(const GeometryParts& parts, LonLat a, LonLat b) {
  for (const Chain& line : parts.lines) {
    if (ChainMeets(line, a, b)) return true;
  }
  for (const std::vector<Chain>& polygon : parts.polygons) {
    for (const Chain& ring : polygon) {
      if (ChainMeets(ring, a, b)) return true;
    }
    if (IsInside(polygon, a)) return true;
  }
  return false;
}

}  // namespace kg_base
