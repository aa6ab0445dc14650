// F = |grad B| of one cell without gaps around it (frontness.h), inlined into
// the loops of front_kernels.cc and pass_kernels.cc.

#ifndef KG_COMPILER_DATA_PLANE_FRONT_AT_H_
#define KG_COMPILER_DATA_PLANE_FRONT_AT_H_

#include <cmath>

#include "kg_compiler/data_plane/front_rows.h"
#include "kg_compiler/data_plane/wide.h"

namespace kg_compiler {

// Sobel weights 1 2 1 over 4, that is 0.25 and 0.5, which are exact in binary.
// The order of summation is fixed: another one would change the last bit.
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
