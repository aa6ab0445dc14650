// Facts and rasters -> the blend of a tensor, from nothing or from the one
// before.

#ifndef KG_COMPILER_DATA_PLANE_COMPILE_BLEND_H_
#define KG_COMPILER_DATA_PLANE_COMPILE_BLEND_H_

#include <cstddef>
#include <memory>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/blended_field.h"
#include "kg_compiler/data_plane/tensor_inputs.h"

namespace kg_compiler {

struct MadeBlend {
  std::shared_ptr<const BlendedField> field;
  // That were computed: all, those in the boxes that changed, or none where
  // nothing did.
  std::size_t cells = 0;
};

// Where the recipes differ in masks, priors and events only, and the layers'
// scales stay, the rest is taken from `previous` (which may be null). Bit by
// bit what is made from nothing. Paper_literal, and layers or weights out of
// float32's comfortable range (1e-30 to 1e30), go the slow way through the
// reference (blend.h).
MadeBlend CompileBlend(const TensorInputs& inputs, const ActiveFacts& active,
                       const std::shared_ptr<const BlendedField>& previous);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_COMPILE_BLEND_H_
