// The inner loops of the data plane: stretches of rows, wide enough for SIMD.
//
// Compiled for several vector widths, the widest that the machine has is used.
// All give the same bits: float32 operations one by one (no contraction, no
// reassociation), reductions only where order cannot matter. NaN and infinite
// values are masked before they are used.

#ifndef KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_

#include <cstddef>
#include <limits>

namespace kg_compiler {

// Columns that are handled in one go: they stay in the first cache.
inline constexpr int kTileCols = 256;

// What a row of cells is to M_hard.
enum CellState : unsigned char { kClosed = 0, kOpen = 1, kLand = 2 };

struct Extremes {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();
};
inline Extremes Both(const Extremes& a, const Extremes& b) {
  return {a.least < b.least ? a.least : b.least,
          a.most > b.most ? a.most : b.most};
}

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
};
// Each gives the extremes of y over the cells whose state is kOpen.
Extremes PassBase(const PassRow& row, int n, float* y);
Extremes PassStored(const PassRow& row, int n, float* y);
Extremes PassSobel(const PassRow& row, int n, float* y);
Extremes PassCentral(const PassRow& row, int n, float* y);

// v += weight p; p without data counts 0.
void AddWeighted(const float* p, float weight, int n, float* v);
// s *= factor, or s = min(s, factor), where inside.
void Attenuate(const unsigned char* inside, float factor, int n, float* s);
void AttenuateToLeast(const unsigned char* inside, float factor, int n,
                      float* s);
// Extremes over the cells whose state is kOpen; values must be >= 0.
Extremes OpenExtremes(const float* y, const unsigned char* state, int n);

// N and w_t of a stored value: w clamp((scale y - low) / range, 0, 1), 0 where
// the range is.
struct RowScale {
  float scale = 1.0f;  // w_t where it stands before N, else 1.
  float low = 0.0f;
  float range = 0.0f;
  float after = 1.0f;
};
void Normalise(const float* y, const RowScale& n, int count, float* u);
// 0 where the state is not kOpen.
void NormaliseOpen(const float* y, const unsigned char* state,
                   const RowScale& n, int count, float* u);

// Are all values finite?
bool AllFinite(const float* values, int n);
// Of finite values: the largest positive and the largest magnitude, 0 if there
// is none.
struct Magnitudes {
  float most = 0.0f;
  float largest = 0.0f;
};
Magnitudes MagnitudesOf(const float* values, int n);
// The largest finite positive value, of all or of kOpen cells; 0 if none is.
float MostOf(const float* values, int n);
float MostOpen(const float* values, const unsigned char* state, int n);

// Writes past the caches, for what is not read again soon. `to` is aligned to
// 16 bytes. Followed by StreamEnd() before another thread reads it.
void Stream(const float* from, int n, float* to);
void StreamEnd();

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_
