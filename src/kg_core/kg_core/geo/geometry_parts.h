// What a geometry is made of, as vertex lists.

#ifndef KG_CORE_GEO_GEOMETRY_PARTS_H_
#define KG_CORE_GEO_GEOMETRY_PARTS_H_

#include <vector>

#include "kg_core/geo/lon_lat.h"

namespace kg_core {

struct GeometryParts {
  using Chain = std::vector<LonLat>;
  std::vector<std::vector<Chain>> polygons;  // Each: shell, then holes; closed.
  std::vector<Chain> lines;                  // A point: one vertex.
};

}  // namespace kg_core

#endif  // KG_CORE_GEO_GEOMETRY_PARTS_H_
