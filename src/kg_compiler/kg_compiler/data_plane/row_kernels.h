// The inner loops of the data plane: stretches of rows, wide enough for SIMD.
//
// Compiled for several vector widths, the widest that the machine has is used.
// All give the same bits: float32 operations one by one (no contraction, no
// reassociation), reductions only where order cannot matter. NaN and infinite
// values are masked before they are used.

#ifndef KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_

#include "kg_compiler/data_plane/front_kernels.h"
#include "kg_compiler/data_plane/pass_kernels.h"

namespace kg_compiler {

// v += weight p; p without data counts 0.
void AddWeighted(const float* p, float weight, int n, float* v);
// s *= factor, or s = min(s, factor), where inside.
void Attenuate(const unsigned char* inside, float factor, int n, float* s);
void AttenuateToLeast(const unsigned char* inside, float factor, int n,
                      float* s);
// Extremes over the cells whose state is kOpen; values must be >= 0.
ValueExtremes OpenExtremes(const float* y, const unsigned char* state, int n);

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
struct ValueMagnitudes {
  float max_positive = 0.0f;
  float max_abs = 0.0f;
};
ValueMagnitudes MagnitudesOf(const float* values, int n);
// The largest finite positive value, of all or of kOpen cells; 0 if none is.
float MaxPositive(const float* values, int n);
float MaxPositiveOpen(const float* values, const unsigned char* state, int n);

// Writes past the caches, for what is not read again soon. `to` is aligned to
// 16 bytes. Followed by StreamEnd() before another thread reads it.
void Stream(const float* from, int n, float* to);
void StreamEnd();

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_
