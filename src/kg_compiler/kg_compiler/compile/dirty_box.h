// The cells of a tensor that a change of facts affects.

#ifndef KG_COMPILER_COMPILE_DIRTY_BOX_H_
#define KG_COMPILER_COMPILE_DIRTY_BOX_H_

#include <optional>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/tensor_inputs.h"

namespace kg_compiler {

// Bounding box of the areas, including buffers, of the constraints that are in
// force in only one of the two inputs (or differ), if there is no other
// difference. Outside of it masks and priors are equal, and so is the blend
// except for the scale of N. Nullopt if any cell may differ.
std::optional<CellBox> DirtyBox(const TensorInputs& before,
                                const TensorInputs& after);

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_DIRTY_BOX_H_
