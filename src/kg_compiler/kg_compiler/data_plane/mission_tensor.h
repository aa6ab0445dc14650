// The mission tensor of one (agent, window): the data plane's product and all
// that the control plane may know of the world's rasters.
//
// A tensor is a name in front of a content. The content is immutable and shared
// by pointer among tensors alike, so that a copy costs a few strings; layers
// are made of it when they are asked for. Every process that holds a content,
// compiled or received, gets the same bits of the layers it has.

#ifndef KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_
#define KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"

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
  kg_base::Raster values;
};

// What tensors are made of. Two kinds: compiled (compiled_tensor.h), and layers
// held as they came (below). Safe to read from several threads.
class TensorContent {
 public:
  virtual ~TensorContent() = default;
  virtual bool Has(Layer layer) const = 0;
  // Of a layer that it has, and of a cell of the grid.
  virtual float At(Layer layer, std::size_t cell) const = 0;
  virtual kg_base::Raster Get(Layer layer) const = 0;
};

// Layers as they are: of a message, which has only some.
std::shared_ptr<const TensorContent> HoldLayers(
    std::vector<TensorLayer> layers);

struct MissionTensor {
  std::string agent_iri;
  int window = 0;
  double confidence = 1.0;
  kg_base::Grid grid;
  std::string hash;  // Of the inputs and parameters it is made of.
  // The facts and files read to make it: its prov:wasDerivedFrom. Sorted.
  std::vector<std::string> derived_from;
  std::shared_ptr<const TensorContent> content;
  // Cells of the blend that were computed to make it: the grid's size, or fewer
  // where a previous content was updated or shared.
  std::size_t cells_computed = 0;

  bool Has(Layer layer) const { return content && content->Has(layer); }
  // One cell of a layer. Throws std::logic_error if the layer is not there,
  // std::out_of_range if the cell is not.
  float At(Layer layer, std::size_t cell) const;
  // The whole layer, made anew by every call: keep what it returns. Throws
  // std::logic_error if the layer is not there.
  kg_base::Raster Get(Layer layer) const;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_
