// Content of a compiled tensor: its blend, and N stored separately. Layers are
// computed on request, so a changed extremum or confidence rewrites no data.

#ifndef KG_COMPILER_DATA_PLANE_COMPILED_TENSOR_H_
#define KG_COMPILER_DATA_PLANE_COMPILED_TENSOR_H_

#include <memory>

#include "kg_compiler/data_plane/blended_field.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_compiler/data_plane/tensor_inputs.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// N of a blend whose values are first multiplied by `before`; low and range in
// the field's unit. `horizon` replaces the fit, if given.
RowScale FitScale(const BlendedField& field, const kg_mission::Policy& policy,
                  float before, const HorizonScale* horizon);

class CompiledTensor : public TensorContent {
 public:
  CompiledTensor(std::shared_ptr<const BlendedField> field,
                 const RowScale& scale, double confidence);

  bool Has(Layer) const override { return true; }
  float At(Layer layer, std::size_t cell) const override;
  kg_base::Raster Get(Layer layer) const override;

  // Columns [first.col, first.col + n) of row first.row; n <= kTileCols.
  void GetRow(Layer layer, kg_base::Cell first, int n, float* values) const;

  const std::shared_ptr<const BlendedField>& field() const { return field_; }

 private:
  void Fuse(const float* y, const unsigned char* state, int n, float* u) const;

  std::shared_ptr<const BlendedField> field_;
  RowScale scale_;
  RowScale unweighted_;  // As the fused scale, without w_t.
  float doubt_ = 0.0f;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_COMPILED_TENSOR_H_
