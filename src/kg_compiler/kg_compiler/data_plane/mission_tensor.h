// The mission tensor of one (agent, window): the data plane's product and the
// only view of the world's rasters in the control plane.
//
// A tensor is a hash with a content. The content is immutable and shared by
// pointer among equal tensors, so that a copy costs a few strings; layers are
// computed from it on request. Every process that holds a content, compiled or
// received, gets bit-identical layers.

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

// Content of a tensor. Two kinds: compiled (compiled_tensor.h), and layers
// stored as received (below). Safe to read from several threads.
class TensorContent {
 public:
  virtual ~TensorContent() = default;
  virtual bool Has(Layer layer) const = 0;
  // Value of one cell of a layer; the layer and the cell must exist.
  virtual float At(Layer layer, std::size_t cell) const = 0;
  virtual kg_base::Raster Get(Layer layer) const = 0;
};

// Content that stores the given layers, e.g. the subset in a message.
std::shared_ptr<const TensorContent> HoldLayers(
    std::vector<TensorLayer> layers);

struct MissionTensor {
  std::string agent_iri;
  int window = 0;
  double confidence = 1.0;
  kg_base::Grid grid;
  std::string hash;  // Hash of its inputs and parameters.
  // Facts and files read to compute it (prov:wasDerivedFrom), sorted.
  std::vector<std::string> derived_from;
  std::shared_ptr<const TensorContent> content;
  // Number of cells of the blend computed for it: the grid's size, or fewer if
  // a previous content was updated or shared.
  std::size_t cells_computed = 0;

  bool Has(Layer layer) const { return content && content->Has(layer); }
  // One cell of a layer. Throws std::logic_error if there is no such layer,
  // std::out_of_range if there is no such cell.
  float At(Layer layer, std::size_t cell) const;
  // The whole layer, recomputed by every call: store the result. Throws
  // std::logic_error if there is no such layer.
  kg_base::Raster Get(Layer layer) const;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_MISSION_TENSOR_H_
