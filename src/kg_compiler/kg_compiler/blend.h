// The blend of Eq. 1 before its masks, and the normalisation N.
//
//   V = alpha B + sum_k beta_k P_k + beta_poi P_events + gamma F(B)

#ifndef KG_COMPILER_BLEND_H_
#define KG_COMPILER_BLEND_H_

#include <vector>

#include "kg_compiler/active_facts.h"
#include "kg_core/raster/grid.h"

namespace kg_compiler {

// sum_k beta_k P_k + beta_poi P_events. P_k is 1 in cells whose centre is
// inside its area, exp(-d^2 / (2 edge^2)) at distance d from the nearest of
// them. P_events = sum value exp(-d^2 / (2 radius^2)); an event of no radius
// has no bump (A42).
std::vector<double> BlendPriors(const kg_core::Grid& grid,
                                const ActiveFacts& active, double beta_poi);

// alpha B + gamma F(B), B and F divided by their maxima over open cells, hence
// in [0, 1] there; negative values and no data count 0.
std::vector<double> BlendValue(const kg_core::Grid& grid,
                               const kg_core::Raster& value,
                               const kg_core::Mask& open,
                               const kg_core::Policy& policy);

// N(x) = (x - low) / range, held in [0, 1]; 0 everywhere if range is 0.
struct Normaliser {
  double low = 0.0;
  double range = 0.0;
  double Apply(double x) const;
};

// From the open cells' values alone (A4). kMax: low 0, range max. kMinMax: the
// two extremes; a constant field as kMax. kPercentile: low 0, range the 98th
// percentile (nearest rank), or the maximum where that is 0.
Normaliser FitNormaliser(const std::vector<double>& values,
                         const kg_core::Mask& open,
                         kg_core::Normalisation kind);

// The one that covers both (A1, `horizon`): lowest low to highest top.
Normaliser Merge(const Normaliser& a, const Normaliser& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_BLEND_H_
