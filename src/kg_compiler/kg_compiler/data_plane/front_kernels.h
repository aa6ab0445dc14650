// F = |grad B| in stretches of rows, as frontness.h says it, in float32; the
// same bits at every vector width (row_kernels.h).

#ifndef KG_COMPILER_DATA_PLANE_FRONT_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_FRONT_KERNELS_H_

namespace kg_compiler {

// Columns that are handled in one go: they stay in the first cache.
inline constexpr int kTileCols = 640;

// Three rows of B around the middle one; [c] is the same column in all. What is
// not on the grid is null (gaps only).
struct FrontRows {
  const float* south = nullptr;
  const float* middle = nullptr;
  const float* north = nullptr;
  // Degrees of longitude per kilometre in these rows.
  float south_deg_per_km = 0, middle_deg_per_km = 0, north_deg_per_km = 0;
  // 1 / kilometres: from the southern row to the northern, and to the middle
  // one from either.
  float per_km = 0, per_km_south = 0, per_km_north = 0;
  // By column: 1 / degrees from the column before to the one after, and from
  // this column to the one after.
  const float* per_deg = nullptr;
  const float* per_deg_after = nullptr;
};

// F where all values of the three rows are finite from the column before the
// first to the one after the last.
void Sobel(const FrontRows& rows, int n, float* f);
void Central(const FrontRows& rows, int n, float* f);
// The same wherever there are gaps; 0 where B has no data. `has_before`,
// `has_after`: is there a column before the first, after the last?
// n <= kTileCols.
struct GapEnds {
  bool has_before = true;
  bool has_after = true;
};
void FrontWithGaps(const FrontRows& rows, bool is_sobel, GapEnds ends, int n,
                   float* f);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_FRONT_KERNELS_H_
