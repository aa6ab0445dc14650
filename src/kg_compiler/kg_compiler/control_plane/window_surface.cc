#include "kg_compiler/control_plane/window_surface.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace kg_compiler {
namespace {

template <typename T>
std::vector<T> CutPatch(const std::vector<T>& cells, int cols,
                        const CellBox& box) {
  std::vector<T> cut;
  for (int row = box.row; row < box.row_end; ++row) {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(row) * cols;
    cut.insert(cut.end(), begin + box.col, begin + box.col_end);
  }
  return cut;
}

// Compares the bits of the cells row by row (NaN = NaN).
template <typename T>
bool Same(const std::vector<T>& patch, const CellBox& patch_box,
          const std::vector<T>& whole, int cols, const CellBox& box) {
  const std::size_t width = patch_box.col_end - patch_box.col;
  const std::size_t bytes = sizeof(T) * (box.col_end - box.col);
  for (int row = box.row; row < box.row_end; ++row) {
    const T* a =
        &patch[(row - patch_box.row) * width + (box.col - patch_box.col)];
    const T* b = &whole[static_cast<std::size_t>(row) * cols + box.col];
    if (std::memcmp(a, b, bytes) != 0) return false;
  }
  return true;
}

}  // namespace

WindowSurface SurfaceOf(const MissionTensor& tensor) {
  const kg_base::Raster feasibility = tensor.Get(Layer::kFeasibility);
  WindowSurface surface;
  surface.cols = tensor.grid.cols();
  surface.open.resize(feasibility.size());
  for (std::size_t i = 0; i < feasibility.size(); ++i) {
    surface.open[i] = feasibility[i] == 1.0f;
  }
  surface.attenuation = tensor.Get(Layer::kAttenuation);
  return surface;
}

SurfacePatch::SurfacePatch(const WindowSurface& surface, const CellBox& box)
    : box_(box),
      open_(CutPatch(surface.open, surface.cols, box)),
      attenuation_(CutPatch(surface.attenuation, surface.cols, box)) {}

bool SurfacePatch::SameOpen(const WindowSurface& other,
                            const CellBox& box) const {
  return Same(open_, box_, other.open, other.cols, box);
}

bool SurfacePatch::SameAttenuation(const WindowSurface& other,
                                   const CellBox& box) const {
  return Same(attenuation_, box_, other.attenuation, other.cols, box);
}

}  // namespace kg_compiler
