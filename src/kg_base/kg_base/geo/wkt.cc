#include "kg_base/geo/wkt.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "kg_base/common/join_strings.h"
#include "kg_base/geo/geos.h"
#include "kg_base/geo/wkt_locate.h"
#include "kg_base/geo/wkt_parser.h"
#include "kg_base/geo/wkt_repair.h"

namespace kg_base {

struct Geometry::Handle {
  GeosGeometry geos;
  GeometryParts parts;
  int type = GEOS_GEOMETRYCOLLECTION;
  bool repaired = false;
  double west_deg = 0.0;
  double east_deg = 0.0;
  double south_deg = 0.0;
  double north_deg = 0.0;
};

namespace {

std::string Digits(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
  return std::string(buffer, end);
}

std::vector<LonLat> Vertices(const GEOSGeometry* chain) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(Geos(), chain);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(Geos(), sequence, &size);
  std::vector<LonLat> vertices(size);
  for (unsigned i = 0; i < size; ++i) {
    GEOSCoordSeq_getXY_r(Geos(), sequence, i, &vertices[i].lon_deg,
                         &vertices[i].lat_deg);
  }
  return vertices;
}

std::vector<std::vector<LonLat>> PolygonRings(const GEOSGeometry* polygon) {
  std::vector<std::vector<LonLat>> rings{
      Vertices(GEOSGetExteriorRing_r(Geos(), polygon))};
  const int holes = GEOSGetNumInteriorRings_r(Geos(), polygon);
  for (int i = 0; i < holes; ++i) {
    rings.push_back(Vertices(GEOSGetInteriorRingN_r(Geos(), polygon, i)));
  }
  return rings;
}

void AddParts(const GEOSGeometry* geometry, GeometryParts* parts) {
  const int type = GEOSGeomTypeId_r(Geos(), geometry);
  if (type == GEOS_POINT || type == GEOS_LINESTRING) {
    parts->lines.push_back(Vertices(geometry));
  } else if (type == GEOS_POLYGON) {
    parts->polygons.push_back(PolygonRings(geometry));
  } else {
    const int members = GEOSGetNumGeometries_r(Geos(), geometry);
    for (int i = 0; i < members; ++i) {
      AddParts(GEOSGetGeometryN_r(Geos(), geometry, i), parts);
    }
  }
}

// GEOS computes bounding boxes lazily and caches them. Computing them here
// makes later reads from several threads free of writes.
void FindBoxes(const GEOSGeometry* geometry) {
  double west_deg = 0.0;
  GEOSGeom_getXMin_r(Geos(), geometry, &west_deg);
  if (GEOSGeomTypeId_r(Geos(), geometry) == GEOS_POLYGON) {
    FindBoxes(GEOSGetExteriorRing_r(Geos(), geometry));
    const int holes = GEOSGetNumInteriorRings_r(Geos(), geometry);
    for (int i = 0; i < holes; ++i) {
      FindBoxes(GEOSGetInteriorRingN_r(Geos(), geometry, i));
    }
    return;
  }
  const int members = GEOSGetNumGeometries_r(Geos(), geometry);
  for (int i = 0; members > 1 && i < members; ++i) {
    FindBoxes(GEOSGetGeometryN_r(Geos(), geometry, i));
  }
}

std::string List(const std::vector<LonLat>& chain) {
  const auto to_text = [](const LonLat& vertex) {
    return Digits(vertex.lon_deg) + " " + Digits(vertex.lat_deg);
  };
  return "(" + JoinStrings(chain, ", ", to_text) + ")";
}

std::string List(const std::vector<std::vector<LonLat>>& rings) {
  const auto to_text = [](const std::vector<LonLat>& ring) {
    return List(ring);
  };
  return "(" + JoinStrings(rings, ", ", to_text) + ")";
}

const char* Keyword(int type) {
  switch (type) {
    case GEOS_POINT:
      return "POINT";
    case GEOS_LINESTRING:
      return "LINESTRING";
    case GEOS_POLYGON:
      return "POLYGON";
    case GEOS_MULTIPOINT:
      return "MULTIPOINT";
    case GEOS_MULTILINESTRING:
      return "MULTILINESTRING";
    case GEOS_MULTIPOLYGON:
      return "MULTIPOLYGON";
    default:
      return "GEOMETRYCOLLECTION";
  }
}

// The text after the keyword.
std::string Body(const GEOSGeometry* geometry) {
  const int type = GEOSGeomTypeId_r(Geos(), geometry);
  if (type == GEOS_POLYGON) return List(PolygonRings(geometry));
  if (type == GEOS_POINT || type == GEOS_LINESTRING) {
    return List(Vertices(geometry));
  }
  std::string text = "(";
  const int members = GEOSGetNumGeometries_r(Geos(), geometry);
  for (int i = 0; i < members; ++i) {
    if (i > 0) text += ", ";
    const GEOSGeometry* member = GEOSGetGeometryN_r(Geos(), geometry, i);
    if (type == GEOS_GEOMETRYCOLLECTION) {
      text += Keyword(GEOSGeomTypeId_r(Geos(), member));
    }
    text += Body(member);
  }
  return text + ")";
}

LonLat PointOf(const GEOSGeometry* point) {
  LonLat position;
  GEOSGeomGetX_r(Geos(), point, &position.lon_deg);
  GEOSGeomGetY_r(Geos(), point, &position.lat_deg);
  return position;
}

}  // namespace

Geometry::Geometry(std::shared_ptr<const Handle> handle)
    : handle_(std::move(handle)) {}

Geometry Geometry::FromWkt(std::string_view text) {
  WktNode node = ParseWkt(text);
  Canonicalise(&node);
  const auto handle = std::make_shared<Handle>();
  handle->geos = Build(node);
  if (!Answer(GEOSisValid_r(Geos(), handle->geos.get()))) {
    handle->geos = Repair(node, handle->geos.get());
    handle->repaired = true;
  }
  const GEOSGeometry* geos = handle->geos.get();
  handle->type = GEOSGeomTypeId_r(Geos(), geos);
  AddParts(geos, &handle->parts);
  FindBoxes(geos);
  GEOSGeom_getXMin_r(Geos(), geos, &handle->west_deg);
  GEOSGeom_getXMax_r(Geos(), geos, &handle->east_deg);
  GEOSGeom_getYMin_r(Geos(), geos, &handle->south_deg);
  GEOSGeom_getYMax_r(Geos(), geos, &handle->north_deg);
  return Geometry(handle);
}

bool Geometry::IsPoint() const { return handle_->type == GEOS_POINT; }
bool Geometry::IsArea() const {
  return handle_->type == GEOS_POLYGON || handle_->type == GEOS_MULTIPOLYGON;
}
bool Geometry::repaired() const { return handle_->repaired; }

LonLat Geometry::Point() const {
  if (!IsPoint()) throw std::logic_error("the geometry is not a point");
  return PointOf(handle_->geos.get());
}

std::string Geometry::Wkt() const {
  return Keyword(handle_->type) + Body(handle_->geos.get());
}

double Geometry::west_deg() const { return handle_->west_deg; }
double Geometry::east_deg() const { return handle_->east_deg; }
double Geometry::south_deg() const { return handle_->south_deg; }
double Geometry::north_deg() const { return handle_->north_deg; }

bool Geometry::Contains(LonLat position) const {
  const Handle& h = *handle_;
  const bool in_box =
      position.lon_deg >= h.west_deg && position.lon_deg <= h.east_deg &&
      position.lat_deg >= h.south_deg && position.lat_deg <= h.north_deg;
  if (!in_box) return false;
  return Touches(h.parts, position);
}

bool Geometry::Intersects(const Geometry& other) const {
  const char answer =
      GEOSIntersects_r(Geos(), handle_->geos.get(), other.handle_->geos.get());
  if (answer == 0 || answer == 1) return answer == 1;
  // Fallback: on vertices rounded in a repair, GEOS's topology graph may fail.
  return Touches(handle_->parts, other.handle_->parts);
}

bool Geometry::Within(const Geometry& other) const {
  return Answer(
      GEOSWithin_r(Geos(), handle_->geos.get(), other.handle_->geos.get()));
}

double Geometry::DistanceDegrees(const Geometry& other) const {
  double distance_deg = 0.0;
  GEOSDistance_r(Geos(), handle_->geos.get(), other.handle_->geos.get(),
                 &distance_deg);
  return distance_deg;
}

std::vector<std::vector<LonLat>> Geometry::Rings() const {
  std::vector<std::vector<LonLat>> rings;
  for (const auto& polygon : handle_->parts.polygons) {
    rings.insert(rings.end(), polygon.begin(), polygon.end());
  }
  return rings;
}

GeometryParts Geometry::Parts() const { return handle_->parts; }

std::string PointWkt(LonLat position) {
  return "POINT(" + Digits(position.lon_deg) + " " + Digits(position.lat_deg) +
         ")";
}

}  // namespace kg_base
