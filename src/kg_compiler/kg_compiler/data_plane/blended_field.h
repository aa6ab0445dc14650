// The blend of a tensor, V' = max(0, V) M_soft in float32, with M_hard and the
// extremes of the open cells by tile: one pass over the rows, and of a change
// only the boxes it touches.

#ifndef KG_COMPILER_DATA_PLANE_BLENDED_FIELD_H_
#define KG_COMPILER_DATA_PLANE_BLENDED_FIELD_H_

#include <memory>
#include <vector>

#include "kg_compiler/data_plane/bands.h"
#include "kg_compiler/data_plane/blend_recipe.h"
#include "kg_compiler/data_plane/layer_table.h"
#include "kg_compiler/data_plane/row_kernels.h"
#include "kg_compiler/data_plane/window_rasters.h"

namespace kg_compiler {

struct BlendedField {
  BlendRecipe recipe;
  std::shared_ptr<const LayerTable> table;  // Of B, where it is read.
  TileLayout tiling;
  RowBands<unsigned char> state;  // CellState: M_hard, and land.
  RowBands<float> masked;         // V' / unit, also where it is forbidden.
  double unit = 1.0;
  std::vector<ValueExtremes>
      extremes;  // By tile, of the cells that N is fitted on.
  // The paper's letter: V is not held at 0, M_hard stands before N, which is
  // fitted on all water.
  bool is_literal = false;

  ValueExtremes All() const;
};

// M_hard by the recipe's hard zones.
void CloseCells(const kg_base::Mask& land, const BlendRecipe& recipe,
                const CellBox& box, RowBands<unsigned char>* state);

// V' and the extremes of rows [row, row_end) of a field whose recipe and state
// are there and whose rows are its own. Rows may be computed by several
// threads, if they begin and end at bands.
void ComputeRows(const WindowRasters& rasters, int row, int row_end,
                 BlendedField* field);
// The same for a box, V' only.
void ComputeBox(const WindowRasters& rasters, const CellBox& box,
                BlendedField* field);
void MeasureTiles(const CellBox& box, BlendedField* field);

// sum beta P at columns [col, col + n) of a row, and M_soft.
void PriorsOfRow(const BlendRecipe& recipe, kg_base::Cell first, int n,
                 float* p);
// False if no zone is there: then s is not written.
bool SoftnessOfRow(const BlendRecipe& recipe, kg_base::Cell first, int n,
                   float* s);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BLENDED_FIELD_H_
