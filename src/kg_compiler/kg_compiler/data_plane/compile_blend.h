// Computes the blend of a tensor from facts and rasters, from scratch or by
// updating the previous one.

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
  // Number of cells computed: all, those in changed boxes, or 0 if nothing
  // changed.
  std::size_t cells = 0;
};

// If the recipes differ in masks, priors and events only, and the layers'
// scales are unchanged, all other cells are copied from `previous` (may be
// null). The result is bit-identical to one from scratch. Paper_literal, and
// layers or weights outside float32's safe range (1e-30 to 1e30), use the
// slower reference (blend.h).
MadeBlend CompileBlend(const TensorInputs& inputs, const ActiveFacts& active,
                       const std::shared_ptr<const BlendedField>& previous);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_COMPILE_BLEND_H_
