// F of one cell where there are no gaps, for the loops that need it.

#ifndef KG_COMPILER_DATA_PLANE_FRONT_AT_H_
#define KG_COMPILER_DATA_PLANE_FRONT_AT_H_

#include <cmath>

#include "kg_compiler/data_plane/front_kernels.h"
#include "kg_compiler/data_plane/wide.h"

namespace kg_compiler {

// The weights' quarter and half are exact.
KG_INLINE float SobelAt(const FrontRows& rows, int c) {
  const float* s = rows.south;
  const float* m = rows.middle;
  const float* t = rows.north;
  const float ks = 0.25f * rows.south_deg_per_km;
  const float km = 0.5f * rows.middle_deg_per_km;
  const float kt = 0.25f * rows.north_deg_per_km;
  const float ky = 0.25f * rows.per_km;
  const float east = ((s[c + 1] - s[c - 1]) * ks + (t[c + 1] - t[c - 1]) * kt) +
                     (m[c + 1] - m[c - 1]) * km;
  const float gx = east * rows.per_deg[c];
  const float middle = t[c] - s[c];
  const float gy =
      (((t[c - 1] - s[c - 1]) + (t[c + 1] - s[c + 1])) + (middle + middle)) *
      ky;
  return std::sqrt(gx * gx + gy * gy);
}

KG_INLINE float CentralAt(const FrontRows& rows, int c) {
  const float gx = (rows.middle[c + 1] - rows.middle[c - 1]) *
                   rows.middle_deg_per_km * rows.per_deg[c];
  const float gy = (rows.north[c] - rows.south[c]) * rows.per_km;
  return std::sqrt(gx * gx + gy * gy);
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_FRONT_AT_H_
