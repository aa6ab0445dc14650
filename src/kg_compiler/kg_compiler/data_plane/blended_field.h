// The blend of a tensor, V' = max(0, V) M_soft in float32, with M_hard and the
// extremes of the open cells by tile: computed in one pass over the rows; a
// change recomputes only the boxes it touches.

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
  std::shared_ptr<const LayerTable> table;  // Table of B, if B is read.
  TileLayout tiling;
  RowBands<unsigned char> state;  // CellState: M_hard, and land.
  RowBands<float> masked;         // V' / unit, also in forbidden cells.
  double unit = 1.0;
  // Extremes per tile, over the cells on which N is fitted.
  std::vector<ValueExtremes> extremes;
  // Mode paper_literal: V is not clamped at 0, M_hard is applied before N,
  // which is fitted on all water.
  bool is_literal = false;

  ValueExtremes All() const;
};

// Applies the recipe's hard zones (M_hard) to `state` within the box.
void CloseCells(const kg_base::Mask& land, const BlendRecipe& recipe,
                const CellBox& box, RowBands<unsigned char>* state);

// Computes V' and the extremes of rows [row, row_end) of a field whose recipe
// and state are set and whose rows are writable. Several threads may compute
// disjoint ranges of whole bands.
void ComputeRows(const WindowRasters& rasters, int row, int row_end,
                 BlendedField* field);
// As ComputeRows for a box, V' only.
void ComputeBox(const WindowRasters& rasters, const CellBox& box,
                BlendedField* field);
void MeasureTiles(const CellBox& box, BlendedField* field);

// Computes sum beta P at columns [first.col, first.col + n) of a row.
void PriorsOfRow(const BlendRecipe& recipe, kg_base::Cell first, int n,
                 float* p);
// Computes M_soft likewise. False if no zone overlaps; s is then not written.
bool SoftnessOfRow(const BlendRecipe& recipe, kg_base::Cell first, int n,
                   float* s);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BLENDED_FIELD_H_
