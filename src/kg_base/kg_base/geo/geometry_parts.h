// The parts of a geometry as vertex lists.

#ifndef KG_BASE_GEO_GEOMETRY_PARTS_H_
#define KG_BASE_GEO_GEOMETRY_PARTS_H_

#include <vector>

#include "kg_base/geo/lon_lat.h"

namespace kg_base {

struct GeometryParts {
  using Chain = std::vector<LonLat>;
  std::vector<std::vector<Chain>> polygons;  // Each: shell, then holes; closed.
  std::vector<Chain> lines;                  // A point: one vertex.
};

}  // namespace kg_base

#endif  // KG_BASE_GEO_GEOMETRY_PARTS_H_
