// The blend of Eq. 1 before its masks, and the normalisation N, in double
// precision, cell by cell: the reference. Tensors are computed in float32
// (compile_blend.h) and agree with it to 1e-6; explanations use the reference.
//
//   V = alpha B + sum_k beta_k P_k + beta_poi P_events + gamma F(B)

#ifndef KG_COMPILER_DATA_PLANE_BLEND_H_
#define KG_COMPILER_DATA_PLANE_BLEND_H_

#include <optional>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/window_rasters.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// One summand of V.
//   kBase   alpha B, B divided by the layer's scale: its maximum over open
//           cells, or the stated scale, or 1; negative values and no data count
//           as 0 (paper_literal: B unchanged).
//   kFront  gamma F(B), F scaled in the same way.
//   kPrior  beta_k P_k: 1 in cells whose centre is inside its area,
//           exp(-d^2 / (2 edge^2)) at distance d from the nearest of them; or
//           its raster unchanged, where no data counts as 0.
//   kEvent  beta_poi value exp(-d^2 / (2 radius^2)); an event without radius
//           has no bump (A42).
struct BlendTerm {
  enum class Kind { kBase, kFront, kPrior, kEvent };
  Kind kind = Kind::kBase;
  double weight = 0.0;  // alpha, gamma, beta_k, beta_poi.
  const kg_mission::PriorLayer* prior = nullptr;  // kPrior.
  const kg_mission::Event* event = nullptr;       // kEvent.
};

// The terms with non-zero weight, in the order of summation.
std::vector<BlendTerm> BlendTerms(const ActiveFacts& active,
                                  const kg_mission::Policy& policy);

// Divisor of a layer. `max_value` is its largest open value, `stated` its
// ex:fullScale or ex:frontFullScale; throws kg_base::InputError if the policy
// requires it and it is missing. Infinite if the layer is 0 everywhere.
double LayerDivisor(const kg_mission::Policy& policy,
                    const std::optional<double>& stated, double max_value);

// Adds a term to `sum`, cell by cell.
void AddTerm(const WindowRasters& rasters, const kg_mission::Policy& policy,
             const kg_base::Mask& open, const BlendTerm& term,
             std::vector<double>* sum);

// Input of N with its components.
struct LayerBlend {
  kg_base::Mask open;               // M_hard.
  std::vector<double> attenuation;  // M_soft.
  std::vector<double> priors;       // sum beta P, events included.
  // max(0, V) M_soft; paper_literal: V M_soft M_hard.
  std::vector<double> masked;
  // Cells on which N is fitted and U may differ from 0: the open cells;
  // paper_literal: all water.
  kg_base::Mask counted;
};
LayerBlend BlendLayers(const ActiveFacts& active,
                       const kg_mission::Policy& policy,
                       const WindowRasters& rasters);

// N(x) = (x - low) / range, clamped to [0, 1]; 0 everywhere if range is 0.
struct ValueNormaliser {
  double low = 0.0;
  double range = 0.0;
  double Apply(double x) const;
};

// Fits N to the values of the counted cells (A4). kMax: low 0, range max.
// kMinMax: the two extremes; a constant field as kMax. kPercentile: low 0,
// range the 98th percentile (nearest rank), or the maximum where that is 0.
ValueNormaliser FitNormaliser(const std::vector<double>& values,
                              const kg_base::Mask& counted,
                              kg_mission::Normalisation kind);

// Normaliser that covers both (A1, `horizon`): lowest low to highest top.
ValueNormaliser Merge(const ValueNormaliser& a, const ValueNormaliser& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BLEND_H_
