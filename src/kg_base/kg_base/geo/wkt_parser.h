// Parser of well-known text, with limits, into plain values. Every error states
// the character position and what was expected there.

#ifndef KG_BASE_GEO_WKT_PARSER_H_
#define KG_BASE_GEO_WKT_PARSER_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "kg_base/geo/lon_lat.h"

namespace kg_base {

inline constexpr std::size_t kMaxWktBytes = 1 << 20;
inline constexpr std::size_t kMaxWktVertices = 100000;
inline constexpr int kMaxWktNesting = 8;  // Nested collections.

enum class WktKind {
  kPoint,
  kLineString,
  kPolygon,
  kMultiPoint,
  kMultiLineString,
  kMultiPolygon,
  kCollection
};

struct WktNode {
  WktKind kind = WktKind::kPoint;
  // Vertex lists. Point: one list with one vertex; line: one list; polygon:
  // closed rings, shell first.
  std::vector<std::vector<LonLat>> chains;
  std::vector<WktNode> members;  // Members of all other kinds.
};

// Reads WKT, and PostGIS's EWKT with SRID=4326. Heights (Z) are left out;
// measures (M) are refused. Guarantees finite coordinates, |latitude| <= 90,
// |longitude| <= 360, no empty parts, and closed rings of at least four
// vertices. Throws InputError.
WktNode ParseWkt(std::string_view text);

}  // namespace kg_base

#endif  // KG_BASE_GEO_WKT_PARSER_H_
