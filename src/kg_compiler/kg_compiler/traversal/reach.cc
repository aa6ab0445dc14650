#include "kg_compiler/traversal/reach.h"

#include <algorithm>

namespace kg_compiler {

const ReachedCell* ReachMap::Find(int index) const {
  const auto at = std::lower_bound(
      cells.begin(), cells.end(), index,
      [](const ReachedCell& cell, int wanted) { return cell.index < wanted; });
  return at != cells.end() && at->index == index ? &*at : nullptr;
}

}  // namespace kg_compiler
