// Three rows of B with their scales: the input of the kernels that compute
// F = |grad B| (frontness.h).

#ifndef KG_COMPILER_DATA_PLANE_FRONT_ROWS_H_
#define KG_COMPILER_DATA_PLANE_FRONT_ROWS_H_

namespace kg_compiler {

// Columns processed together, so that they stay in the L1 cache.
inline constexpr int kTileCols = 640;

// Three rows of B around the middle one; [c] is the same column in all. A row
// beyond the grid is null (FrontWithGaps only).
struct FrontRows {
  const float* south = nullptr;
  const float* middle = nullptr;
  const float* north = nullptr;
  // Degrees of longitude per kilometre in these rows.
  float south_deg_per_km = 0, middle_deg_per_km = 0, north_deg_per_km = 0;
  // Inverse row distances [1/km]: south to north, south to middle, and middle
  // to north.
  float per_km = 0, per_km_south = 0, per_km_north = 0;
  // Inverse column distances [1/deg], by column: from the previous to the next
  // column, and from this column to the next.
  const float* per_deg = nullptr;
  const float* per_deg_after = nullptr;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_FRONT_ROWS_H_
