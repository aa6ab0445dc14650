// A box of a grid's cells.

#ifndef KG_COMPILER_TRAVERSAL_CELL_BOX_H_
#define KG_COMPILER_TRAVERSAL_CELL_BOX_H_

namespace kg_compiler {

// Rows [row, row_end), columns [col, col_end).
struct CellBox {
  int row = 0;
  int row_end = 0;
  int col = 0;
  int col_end = 0;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_CELL_BOX_H_
