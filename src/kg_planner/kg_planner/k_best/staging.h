// Staging: seams of a path that are taken for what comes later. From where the
// path is, another seam would bring more at once,
//
//   gain at once = rewards of the stops and the end + what their tokens are
//                  worth beyond those earned before - cost,
//
// but on the best path is this one. Compared on the score grid.

#ifndef KG_PLANNER_K_BEST_STAGING_H_
#define KG_PLANNER_K_BEST_STAGING_H_

#include <vector>

#include "kg_planner/k_best/path.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

// By stage, whether the path's seam into it is such a one. Seams that `masks`
// forbid are not compared with. Throws as FindKBest() does, and if `path` does
// not lead through `trellis`.
std::vector<bool> FindStaging(const Trellis& trellis, const PathMasks& masks,
                              const Path& path);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_STAGING_H_
