#include "kg_base/geo/wkt_repair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

// Fraction of an area that rounding in an overlay may lose.
constexpr double kAreaTolerance = 1e-9;
constexpr int kMaxRepairPasses = 4;

template <typename Visit>
void ForEachChain(WktNode* node, const Visit& visit) {
  for (std::vector<LonLat>& chain : node->chains) visit(&chain);
  for (WktNode& member : node->members) ForEachChain(&member, visit);
}

void RefuseLongEdges(const std::vector<LonLat>& chain) {
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const double step_deg = std::abs(chain[i].lon_deg - chain[i - 1].lon_deg);
    // A step of exactly 360 degrees is an edge of a box around the globe.
    if (step_deg > 180.0 && step_deg < 360.0) {
      throw InputError(
          "WKT: an edge spans more than 180 degrees of longitude; expected a "
          "geometry that does not cross the antimeridian (split it there)");
    }
  }
}

int GeosType(WktKind kind) {
  switch (kind) {
    case WktKind::kPoint:
      return GEOS_POINT;
    case WktKind::kLineString:
      return GEOS_LINESTRING;
    case WktKind::kPolygon:
      return GEOS_POLYGON;
    case WktKind::kMultiPoint:
      return GEOS_MULTIPOINT;
    case WktKind::kMultiLineString:
      return GEOS_MULTILINESTRING;
    case WktKind::kMultiPolygon:
      return GEOS_MULTIPOLYGON;
    case WktKind::kCollection:
      return GEOS_GEOMETRYCOLLECTION;
  }
  throw std::logic_error("no such WKT kind");
}

GeosGeometry MakeValid(const GEOSGeometry* geometry,
                       GEOSMakeValidMethods method) {
  GEOSMakeValidParams* params = GEOSMakeValidParams_create_r(Geos());
  GEOSMakeValidParams_setMethod_r(Geos(), params, method);
  GEOSMakeValidParams_setKeepCollapsed_r(Geos(), params, 0);
  GEOSGeometry* valid = GEOSMakeValidWithParams_r(Geos(), geometry, params);
  GEOSMakeValidParams_destroy_r(Geos(), params);
  return Owned(valid);
}

double EvenOddArea(const std::vector<LonLat>& ring) {
  const GeosGeometry polygon = GeosPolygon({ring});
  return GeosArea(MakeValid(polygon.get(), GEOS_MAKE_VALID_LINEWORK).get());
}

double AreaBeyondDoubt(const WktNode& polygon) {
  double area = EvenOddArea(polygon.chains.front());
  for (std::size_t i = 1; i < polygon.chains.size(); ++i) {
    area -= EvenOddArea(polygon.chains[i]);
  }
  return area;
}

bool CoversWhatIsBeyondDoubt(const GEOSGeometry* whole, const WktNode& node) {
  for (const WktNode& member : node.members) {
    if (!CoversWhatIsBeyondDoubt(whole, member)) return false;
  }
  if (node.kind != WktKind::kPolygon) return true;
  const GeosGeometry polygon = Build(node);
  // A valid member must be covered completely. Of an invalid one only the size
  // of the area is known, not its location.
  if (Answer(GEOSisValid_r(Geos(), polygon.get()))) {
    const double area = GeosArea(polygon.get());
    const GeosGeometry lost =
        Owned(GEOSDifference_r(Geos(), polygon.get(), whole));
    return GeosArea(lost.get()) <= area * kAreaTolerance;
  }
  return GeosArea(whole) >= AreaBeyondDoubt(node) * (1.0 - kAreaTolerance);
}

// A repair inserts vertices where edges cross. Their rounding can make the
// result slightly invalid again, which a second pass repairs and the third
// confirms.
GeosGeometry MakeValidThroughout(const GEOSGeometry* invalid) {
  GeosGeometry valid = MakeValid(invalid, GEOS_MAKE_VALID_STRUCTURE);
  for (int pass = 0; pass < kMaxRepairPasses; ++pass) {
    if (Answer(GEOSisValid_r(Geos(), valid.get()))) break;
    valid = MakeValid(valid.get(), GEOS_MAKE_VALID_STRUCTURE);
  }
  return valid;
}

std::string Reason(const GEOSGeometry* invalid) {
  char* reason = GEOSisValidReason_r(Geos(), invalid);
  const std::string text = reason == nullptr ? "invalid" : reason;
  GEOSFree_r(Geos(), reason);
  return text;
}

}  // namespace

void Canonicalise(WktNode* node) {
  double west_deg = std::numeric_limits<double>::infinity();
  double east_deg = -west_deg;
  ForEachChain(node, [&](std::vector<LonLat>* chain) {
    RefuseLongEdges(*chain);
    for (const LonLat& vertex : *chain) {
      west_deg = std::min(west_deg, vertex.lon_deg);
      east_deg = std::max(east_deg, vertex.lon_deg);
    }
  });
  // Shift the whole geometry by one turn, so that its shape is preserved. If it
  // still does not fit into [-180, 180], it crosses the antimeridian.
  const double turn_deg = west_deg >= 180.0   ? -360.0
                          : east_deg < -180.0 ? 360.0
                                              : 0.0;
  if (west_deg + turn_deg < -180.0 || east_deg + turn_deg > 180.0) {
    throw InputError(
        "WKT: longitudes run from " + std::to_string(west_deg) + " to " +
        std::to_string(east_deg) +
        "; expected a geometry that does not cross the antimeridian (split it "
        "there)");
  }
  if (turn_deg == 0.0) return;
  ForEachChain(node, [turn_deg](std::vector<LonLat>* chain) {
    for (LonLat& vertex : *chain) vertex.lon_deg += turn_deg;
  });
}

GeosGeometry Build(const WktNode& node) {
  if (node.kind == WktKind::kPoint) return GeosPoint(node.chains[0][0]);
  if (node.kind == WktKind::kLineString) return GeosLine(node.chains[0]);
  if (node.kind == WktKind::kPolygon) return GeosPolygon(node.chains);
  std::vector<GeosGeometry> members;
  for (const WktNode& member : node.members) members.push_back(Build(member));
  std::vector<GEOSGeometry*> raw;  // createCollection takes them.
  for (GeosGeometry& member : members) raw.push_back(member.release());
  return Owned(GEOSGeom_createCollection_r(Geos(), GeosType(node.kind),
                                           raw.data(),
                                           static_cast<unsigned>(raw.size())));
}

GeosGeometry Repair(const WktNode& node, const GEOSGeometry* invalid) {
  GeosGeometry valid = MakeValidThroughout(invalid);
  const std::string reason = Reason(invalid);
  // Negated comparison, so that NaN is rejected as well.
  if (!(GeosArea(valid.get()) > 0.0)) {
    throw InputError("WKT: the polygon encloses no area (" + reason +
                     "), expected one that does");
  }
  if (!Answer(GEOSisValid_r(Geos(), valid.get())) ||
      !CoversWhatIsBeyondDoubt(valid.get(), node)) {
    throw InputError("WKT: the polygon is invalid (" + reason +
                     ") and cannot be repaired without losing area; expected "
                     "a valid polygon");
  }
  return valid;
}

}  // namespace kg_base
