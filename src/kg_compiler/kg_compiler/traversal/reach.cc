#include <algorithm>

#include "kg_compiler/traversal/fan.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

const ReachedCell* Reach::Find(int index) const {
  const auto at = std::lower_bound(
      cells.begin(), cells.end(), index,
      [](const ReachedCell& cell, int wanted) { return cell.index < wanted; });
  return at != cells.end() && at->index == index ? &*at : nullptr;
}

Reach ComputeReach(const Voyage& voyage) { return Fan(voyage).Run(); }

}  // namespace kg_compiler
