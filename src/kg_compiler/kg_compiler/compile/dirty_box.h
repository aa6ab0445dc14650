// Which cells of a tensor a change of facts speaks of.

#ifndef KG_COMPILER_COMPILE_DIRTY_BOX_H_
#define KG_COMPILER_COMPILE_DIRTY_BOX_H_

#include <optional>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/tensor_inputs.h"

namespace kg_compiler {

// The box around the areas, buffers included, of the constraints that only one
// of the two has in force (or has otherwise), if that is all they differ in:
// outside of it masks and priors are the same, and the blend's values but for
// the scale of N. Nothing if they may differ anywhere.
std::optional<CellBox> DirtyBox(const TensorInputs& before,
                                const TensorInputs& after);

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_DIRTY_BOX_H_
