// A backward Viterbi pass that also checks the trellis, so that large ones are
// read once: for trellises without tokens, stops and limits whose seams ascend
// by (from, to).

#ifndef KG_PLANNER_K_BEST_PLAIN_PASS_H_
#define KG_PLANNER_K_BEST_PLAIN_PASS_H_

#include <optional>
#include <vector>

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

// Best suffixes from the nodes before a stage.
struct ViterbiLevel {
  // Score of the best suffix by node; -infinity = none.
  std::vector<double> best;
  std::vector<int> first_seam;  // First seam by node, plus one entry.
};

struct PlainPass {
  double largest_total = 0.0;        // As in TrellisSummary.
  std::vector<ViterbiLevel> levels;  // Stages + 1 levels.
};

// Nullopt if the trellis is not of that kind, or invalid.
std::optional<PlainPass> PassPlain(const Trellis& trellis);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_PLAIN_PASS_H_
