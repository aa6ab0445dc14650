// The blend of Eq. 1 before its masks, and the normalisation N.
//
//   V = alpha B + sum_k beta_k P_k + beta_poi P_events + gamma F(B)

#ifndef KG_COMPILER_DATA_PLANE_BLEND_H_
#define KG_COMPILER_DATA_PLANE_BLEND_H_

#include <vector>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_core/raster/grid.h"

namespace kg_compiler {

// What the blend reads of one window, all on one grid.
struct BlendInputs {
  const kg_core::Grid& grid;
  const kg_core::Mask& land;
  const kg_core::Raster& value;  // B_t in its own unit; NaN = no data.
};

// One summand of V.
//   kBase   alpha B, B divided by its maximum over open cells, hence in [0, 1]
//           there; negative values and no data count 0.
//   kFront  gamma F(B), F likewise.
//   kPrior  beta_k P_k: 1 in cells whose centre is inside its area,
//           exp(-d^2 / (2 edge^2)) at distance d from the nearest of them.
//   kEvent  beta_poi value exp(-d^2 / (2 radius^2)); an event of no radius has
//           no bump (A42).
struct BlendTerm {
  enum class Kind { kBase, kFront, kPrior, kEvent };
  Kind kind = Kind::kBase;
  double weight = 0.0;  // alpha, gamma, beta_k, beta_poi.
  const kg_core::PriorLayer* prior = nullptr;  // kPrior.
  const kg_core::Event* event = nullptr;       // kEvent.
};

// Those of any weight, in the order in which they are summed.
std::vector<BlendTerm> BlendTerms(const ActiveFacts& active,
                                  const kg_core::Policy& policy);

// Adds a term to `sum`, cell by cell: the one implementation behind tensors and
// their explanations.
void AddTerm(const BlendInputs& inputs, const kg_core::Mask& open,
             const BlendTerm& term, std::vector<double>* sum);

// What N is applied to, and what it is made of.
struct Blend {
  kg_core::Mask open;               // M_hard.
  std::vector<double> attenuation;  // M_soft.
  std::vector<double> priors;       // sum beta P, events included.
  std::vector<double> masked;       // max(0, V) * M_soft.
};
Blend BlendLayers(const ActiveFacts& active, const kg_core::Policy& policy,
                  const BlendInputs& inputs);

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

#endif  // KG_COMPILER_DATA_PLANE_BLEND_H_
