// The part of a window's tensor that flights depend on: open cells and soft
// constraints. Patches of it are cached and compared with the next tensor.

#ifndef KG_COMPILER_CONTROL_PLANE_WINDOW_SURFACE_H_
#define KG_COMPILER_CONTROL_PLANE_WINDOW_SURFACE_H_

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/mission_tensor.h"

namespace kg_compiler {

struct WindowSurface {
  int cols = 0;
  kg_base::Mask open;           // 1 = may be entered.
  kg_base::Raster attenuation;  // M_soft.
};
WindowSurface SurfaceOf(const MissionTensor& tensor);

// A box cut out of a surface.
class SurfacePatch {
 public:
  SurfacePatch() = default;
  SurfacePatch(const WindowSurface& surface, const CellBox& box);

  // Does `other` have the same values in a box, which lies within the patch?
  bool SameOpen(const WindowSurface& other, const CellBox& box) const;
  bool SameAttenuation(const WindowSurface& other, const CellBox& box) const;

 private:
  CellBox box_;
  kg_base::Mask open_;
  kg_base::Raster attenuation_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WINDOW_SURFACE_H_
