// A backward Viterbi pass that checks the trellis as it goes, so that a large
// one is read once: for those without tokens, stops and limits whose seams
// ascend by (from, to).

#ifndef KG_PLANNER_K_BEST_PLAIN_PASS_H_
#define KG_PLANNER_K_BEST_PLAIN_PASS_H_

#include <optional>
#include <vector>

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

// What leads on from the nodes before a stage.
struct ViterbiLevel {
  std::vector<double> best;     // By node: of the best rest; -infinity: none.
  std::vector<int> first_seam;  // By node, and one more.
};

struct PlainPass {
  double largest_total = 0.0;        // As in TrellisSummary.
  std::vector<ViterbiLevel> levels;  // One more than stages.
};

// Nothing if the trellis is not of that kind, or not sound.
std::optional<PlainPass> PassPlain(const Trellis& trellis);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_PLAIN_PASS_H_
