// The pass over a stretch of a row: layers, priors, M_soft and the extremes of
// the open cells at once; the same bits at every vector width (row_kernels.h).

#ifndef KG_COMPILER_DATA_PLANE_PASS_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_PASS_KERNELS_H_

#include <limits>

#include "kg_compiler/data_plane/front_kernels.h"

namespace kg_compiler {

// What a row of cells is to M_hard.
enum CellState : unsigned char { kClosed = 0, kOpen = 1, kLand = 2 };

struct ValueExtremes {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();
};
inline ValueExtremes Both(const ValueExtremes& a, const ValueExtremes& b) {
  return {a.least < b.least ? a.least : b.least,
          a.most > b.most ? a.most : b.most};
}

// A stretch of the pass:
//   y = max(0, base max(0, B) + front F + weight p) s
struct PassRow {
  FrontRows rows;                 // PassSobel, PassCentral: free of gaps.
  const float* values = nullptr;  // B, PassBase and PassStored.
  const float* fronts = nullptr;  // F, PassStored.
  float base = 0.0f;
  float front = 0.0f;
  const float* priors = nullptr;  // p; without data it counts 0. Or null.
  float weight = 0.0f;
  // s: `factor` where inside, 1 elsewhere; or `softness`; or, both null, 1.
  const unsigned char* inside = nullptr;
  float factor = 1.0f;
  const float* softness = nullptr;
  const unsigned char* state = nullptr;
  // Is it to be fetched from memory, what comes 2 KB on as well?
  bool is_far = false;
};
// Each gives the extremes of y over the cells whose state is kOpen.
ValueExtremes PassBase(const PassRow& row, int n, float* y);
ValueExtremes PassStored(const PassRow& row, int n, float* y);
ValueExtremes PassSobel(const PassRow& row, int n, float* y);
ValueExtremes PassCentral(const PassRow& row, int n, float* y);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_PASS_KERNELS_H_
