// Geometries of facts: well-known text in CRS84 (longitude latitude, degrees),
// read with limits on length, vertices and nesting. GeoSPARQL's leading <crs>
// IRI or EWKT's SRID=4326 and heights (Z) are removed, non-finite or
// out-of-range coordinates are rejected, and invalid polygons are repaired by
// GEOS (never made smaller than their valid part) or rejected. Predicates are
// GEOS's, planar in degrees.
//
// Longitudes of -360..360 are accepted; a geometry is shifted by a whole turn
// into [-180, 180] (a point into [-180, 180)). A geometry that crosses the
// antimeridian is rejected: it has to be split at 180 degrees.
// Source: OGC 06-103r4 (WKT), OGC 11-052r4 (GeoSPARQL), 8.5.

#ifndef KG_BASE_GEO_WKT_H_
#define KG_BASE_GEO_WKT_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kg_base/geo/geometry_parts.h"
#include "kg_base/geo/lon_lat.h"

namespace kg_base {

// An immutable geometry; cheap to copy. Safe to read from several threads.
class Geometry {
 public:
  // Throws InputError with the position of the mistake in the text.
  static Geometry FromWkt(std::string_view text);

  bool IsPoint() const;
  bool IsArea() const;   // Polygon or multipolygon.
  LonLat Point() const;  // POINT only; throws std::logic_error otherwise.
  std::string Wkt() const;
  double west_deg() const;
  double east_deg() const;
  double south_deg() const;
  double north_deg() const;

  bool Contains(LonLat position) const;  // Interior or boundary.
  bool Intersects(const Geometry& other) const;
  bool Within(const Geometry& other) const;
  double DistanceDegrees(const Geometry& other) const;  // Planar, for geof.
  // Rings of an area as closed vertex lists, for display.
  std::vector<std::vector<LonLat>> Rings() const;
  GeometryParts Parts() const;
  bool repaired() const;  // Was it invalid as written?

  struct Handle;

 private:
  explicit Geometry(std::shared_ptr<const Handle> handle);
  std::shared_ptr<const Handle> handle_;
};

// "POINT(lon lat)" with enough digits to read back the same position.
std::string PointWkt(LonLat position);

}  // namespace kg_base

#endif  // KG_BASE_GEO_WKT_H_
