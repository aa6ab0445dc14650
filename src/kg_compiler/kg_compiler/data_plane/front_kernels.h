// F = |grad B| (frontness.h) for a segment of a row, in float32; bit-identical
// at every vector width (row_kernels.h).

#ifndef KG_COMPILER_DATA_PLANE_FRONT_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_FRONT_KERNELS_H_

#include "kg_compiler/data_plane/front_rows.h"

namespace kg_compiler {

// F of a segment without gaps: all values of the three rows are finite, from
// the column before the first to the one after the last.
void Sobel(const FrontRows& rows, int n, float* f);
void Central(const FrontRows& rows, int n, float* f);
// F of a segment with gaps; 0 where B has no data. `has_before`, `has_after`:
// is there a column before the first, after the last? n <= kTileCols.
struct GapEnds {
  bool has_before = true;
  bool has_after = true;
};
void FrontWithGaps(const FrontRows& rows, bool is_sobel, GapEnds ends, int n,
                   float* f);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_FRONT_KERNELS_H_
