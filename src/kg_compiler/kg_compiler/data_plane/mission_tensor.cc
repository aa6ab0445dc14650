#include "kg_compiler/data_plane/mission_tensor.h"

#include <stdexcept>

namespace kg_compiler {

const char* Name(Layer layer) {
  switch (layer) {
    case Layer::kReward:
      return "REWARD";
    case Layer::kUncertainty:
      return "UNCERTAINTY";
    case Layer::kPolicy:
      return "POLICY";
    case Layer::kAttenuation:
      return "ATTENUATION";
    case Layer::kFeasibility:
      return "FEASIBILITY";
    case Layer::kFused:
      return "FUSED";
  }
  throw std::logic_error("a layer without a name");
}

bool MissionTensor::Has(Layer layer) const {
  for (const TensorLayer& candidate : layers) {
    if (candidate.layer == layer) return true;
  }
  return false;
}

float MissionTensor::At(Layer layer, std::size_t cell) const {
  return Get(layer).at(cell);
}

const kg_core::Raster& MissionTensor::Get(Layer layer) const {
  for (const TensorLayer& candidate : layers) {
    if (candidate.layer == layer) return candidate.values;
  }
  throw std::logic_error(std::string("the tensor has no layer ") + Name(layer));
}

}  // namespace kg_compiler
