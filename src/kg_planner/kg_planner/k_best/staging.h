// Staging: seams of a path that are taken for a later gain. From the same
// source, another seam would have a larger immediate gain,
//
//   immediate gain = rewards of the stops and the end + what their tokens
//                  add to those earned before - cost,
//
// but the best path takes this one. Compared on the score grid.

#ifndef KG_PLANNER_K_BEST_STAGING_H_
#define KG_PLANNER_K_BEST_STAGING_H_

#include <vector>

#include "kg_planner/k_best/path.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

// By stage, whether the path's seam into it is a staging seam. Masked seams are
// not alternatives. Throws as FindKBest() does, and if `path` is not a path of
// `trellis`.
std::vector<bool> FindStaging(const Trellis& trellis, const PathMasks& masks,
                              const Path& path);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_STAGING_H_
