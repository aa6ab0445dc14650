#include "kg_compiler/data_plane/mission_tensor.h"

#include <stdexcept>
#include <utility>

namespace kg_compiler {
namespace {

class HeldLayers : public TensorContent {
 public:
  explicit HeldLayers(std::vector<TensorLayer> layers)
      : layers_(std::move(layers)) {}

  bool Has(Layer layer) const override { return Find(layer) != nullptr; }
  float At(Layer layer, std::size_t cell) const override {
    return (*Find(layer))[cell];
  }
  kg_base::Raster Get(Layer layer) const override { return *Find(layer); }

 private:
  const kg_base::Raster* Find(Layer layer) const {
    for (const TensorLayer& candidate : layers_) {
      if (candidate.layer == layer) return &candidate.values;
    }
    return nullptr;
  }

  std::vector<TensorLayer> layers_;
};

void CheckHas(const MissionTensor& tensor, Layer layer) {
  if (tensor.Has(layer)) return;
  throw std::logic_error(std::string("the tensor has no layer ") + Name(layer));
}

}  // namespace

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

std::shared_ptr<const TensorContent> HoldLayers(
    std::vector<TensorLayer> layers) {
  return std::make_shared<HeldLayers>(std::move(layers));
}

float MissionTensor::At(Layer layer, std::size_t cell) const {
  CheckHas(*this, layer);
  if (cell >= grid.size()) throw std::out_of_range("no such cell in the grid");
  return content->At(layer, cell);
}

kg_base::Raster MissionTensor::Get(Layer layer) const {
  CheckHas(*this, layer);
  return content->Get(layer);
}

}  // namespace kg_compiler
