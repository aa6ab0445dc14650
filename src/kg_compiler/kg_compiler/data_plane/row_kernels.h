// The inner loops of the data plane over segments of rows, vectorised.
//
// Compiled for several vector widths; the widest one supported is used. All
// give bit-identical results: float32 operations without contraction or
// reassociation, reductions only where the order is irrelevant. NaN and
// infinite values are masked before use.

#ifndef KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_
#define KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_

#include "kg_compiler/data_plane/front_kernels.h"
#include "kg_compiler/data_plane/pass_kernels.h"

namespace kg_compiler {

// v += weight p; no data in p counts as 0.
void AddWeighted(const float* p, float weight, int n, float* v);
// s *= factor, or s = min(s, factor), where inside.
void Attenuate(const unsigned char* inside, float factor, int n, float* s);
void AttenuateToLeast(const unsigned char* inside, float factor, int n,
                      float* s);
// Extremes over the cells whose state is kOpen; values must be >= 0.
ValueExtremes OpenExtremes(const float* y, const unsigned char* state, int n);

// N and w_t of a stored value y: after clamp((scale y - low) / range, 0, 1); 0
// if the range is 0.
struct RowScale {
  float scale = 1.0f;  // w_t if applied before N, else 1.
  float low = 0.0f;
  float range = 0.0f;
  float after = 1.0f;
};
void Normalise(const float* y, const RowScale& n, int count, float* u);
// u = N(y) where the state is kOpen, 0 elsewhere.
void NormaliseOpen(const float* y, const unsigned char* state,
                   const RowScale& n, int count, float* u);

// Are all values finite?
bool AllFinite(const float* values, int n);
// Largest positive value and largest magnitude of the finite values; 0 if there
// is none.
struct ValueMagnitudes {
  float max_positive = 0.0f;
  float max_abs = 0.0f;
};
ValueMagnitudes MagnitudesOf(const float* values, int n);
// Largest finite positive value of all or of kOpen cells; 0 if there is none.
float MaxPositive(const float* values, int n);
float MaxPositiveOpen(const float* values, const unsigned char* state, int n);

// Copies with non-temporal stores, for data not read again soon. `to` is
// aligned to 16 bytes. Call StreamEnd() before another thread reads it.
void Stream(const float* from, int n, float* to);
void StreamEnd();

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_ROW_KERNELS_H_
