// The mission tensor of one (agent, window): the data plane's product and all
// that the control plane may know of the world's rasters.

#ifndef KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_
#define KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_

#include <string>
#include <vector>

#include "kg_core/raster/grid.h"

namespace kg_compiler {

// Layer kinds (A6, A7). All dimensionless.
enum class Layer {
  kReward,       // N(alpha B + sum beta P + gamma F, attenuated), in [0, 1].
  kUncertainty,  // 1 - w_t.
  kPolicy,       // Priors: sum beta_k P_k, before normalisation.
  kAttenuation,  // M_soft in [0, 1].
  kFeasibility,  // M_hard: 1 open, 0 forbidden (no_go, buffer), NaN land.
  kFused,        // U of Eq. 1 with w_t; exactly 0 where forbidden; never NaN.
};
const char* Name(Layer layer);  // "REWARD", ...

struct TensorLayer {
  Layer layer = Layer::kFused;
  kg_core::Raster values;
};

struct MissionTensor {
  std::string agent_iri;
  int window = 0;
  double confidence = 1.0;
  kg_core::Grid grid;
  std::vector<TensorLayer> layers;
  std::string hash;  // Of the inputs and parameters it is made of.
  // The facts and files read to make it: its prov:wasDerivedFrom. Sorted.
  std::vector<std::string> derived_from;

  bool Has(Layer layer) const;
  // One cell of a layer. Throws std::logic_error if the layer is not there.
  float At(Layer layer, std::size_t cell) const;
  // Throws std::logic_error if the layer is not there.
  const kg_core::Raster& Get(Layer layer) const;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_
