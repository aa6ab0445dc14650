// State of a cell in M_hard, and the extremes of values over open cells.

#ifndef KG_COMPILER_DATA_PLANE_EXTREMES_H_
#define KG_COMPILER_DATA_PLANE_EXTREMES_H_

#include <limits>

namespace kg_compiler {

enum CellState : unsigned char { kClosed = 0, kOpen = 1, kLand = 2 };

struct ValueExtremes {
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();
};
inline ValueExtremes Both(const ValueExtremes& a, const ValueExtremes& b) {
  return {a.min < b.min ? a.min : b.min, a.max > b.max ? a.max : b.max};
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_EXTREMES_H_
