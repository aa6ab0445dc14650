// One pass over a segment of a row: layers, priors, M_soft and the extremes of
// the open cells; bit-identical at every vector width (row_kernels.h).

#ifndef KG_COMPILER_DATA_PLANE_PASS_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_PASS_KERNELS_H_

#include "kg_compiler/data_plane/extremes.h"
#include "kg_compiler/data_plane/front_rows.h"

namespace kg_compiler {

// The input of a pass over one segment:
//   y = max(0, base max(0, B) + front F + weight p) s
struct PassRow {
  FrontRows rows;                 // PassSobel, PassCentral: no gaps.
  const float* values = nullptr;  // B, PassBase and PassStored.
  const float* fronts = nullptr;  // F, PassStored.
  float base = 0.0f;
  float front = 0.0f;
  const float* priors = nullptr;  // p, no data counts as 0; or null.
  float weight = 0.0f;
  // s: `factor` where inside, 1 elsewhere; or `softness`; or, both null, 1.
  const unsigned char* inside = nullptr;
  float factor = 1.0f;
  const float* softness = nullptr;
  const unsigned char* state = nullptr;
  // Prefetch 2 KB ahead: the rows are in main memory, not in a cache.
  bool is_far = false;
};
// Compute y; return its extremes over the cells whose state is kOpen.
ValueExtremes PassBase(const PassRow& row, int n, float* y);
ValueExtremes PassStored(const PassRow& row, int n, float* y);
ValueExtremes PassSobel(const PassRow& row, int n, float* y);
ValueExtremes PassCentral(const PassRow& row, int n, float* y);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_PASS_KERNELS_H_
