#include "kg_planner/k_best/plain_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "kg_planner/k_best/no_value.h"
#include "kg_planner/k_best/row_kernel.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

// Seams sampled per stage to guess its largest cost.
constexpr std::size_t kSample = 512;

bool IsPlain(const Trellis& trellis) {
  return trellis.resource_limit == kNoLimit && trellis.more_limits.empty() &&
         std::all_of(trellis.stages.begin(), trellis.stages.end(),
                     [](const Stage& stage) {
                       return stage.via.empty() && stage.more_resources.empty();
                     });
}

// Nullopt if a node has tokens or a reward is not finite.
std::optional<double> LargestReward(const Stage& stage) {
  double largest = 0.0;
  bool sound = true;
  for (const Node& node : stage.nodes) {
    sound = sound && node.tokens.empty() && std::isfinite(node.reward);
    largest = std::max(largest, std::abs(node.reward));
  }
  if (!sound) return std::nullopt;
  return largest;
}

double GuessCost(const Stage& stage) {
  double largest = 0.0;
  const std::size_t count = std::min(stage.seams.size(), kSample);
  for (std::size_t i = 0; i < count; ++i) {
    largest = std::max(largest, stage.seams[i].cost);
  }
  return largest;
}

class PlainPasser {
 public:
  explicit PlainPasser(const Trellis& trellis)
      : trellis_(trellis), costs_(trellis.stages.size(), 0.0) {}

  std::optional<PlainPass> Pass() {
    for (std::size_t s = 0; s < trellis_.stages.size(); ++s) {
      const auto largest = LargestReward(trellis_.stages[s]);
      if (!largest) return std::nullopt;
      rewards_.push_back(*largest);
      costs_[s] = GuessCost(trellis_.stages[s]);
    }
    // The grid depends on totals known only after the pass. A guess is usually
    // right, since only the power of two matters.
    double guess = Total();
    for (int attempt = 0; attempt < 2; ++attempt) {
      if (!std::isfinite(guess) || !Relax(ScoreGrid(guess))) {
        return std::nullopt;
      }
      const double total = Total();
      if (!std::isfinite(total)) return std::nullopt;
      if (ScoreGrid(total).step() == ScoreGrid(guess).step()) {
        return PlainPass{total, std::move(levels_)};
      }
      guess = total;
    }
    return std::nullopt;
  }

 private:
  // Summed in the order of CheckTrellis() for bitwise equal results.
  double Total() const {
    double total = 0.0;
    for (std::size_t s = 0; s < costs_.size(); ++s) {
      total += rewards_[s] + costs_[s];
    }
    return total;
  }

  bool Relax(const ScoreGrid& grid) {
    const std::size_t stages = trellis_.stages.size();
    levels_.assign(stages + 1, {});
    levels_[stages].best.assign(NodesBefore(trellis_, stages), 0.0);
    for (std::size_t s = stages; s-- > 0;) {
      if (!RelaxStage(grid, s)) return false;
    }
    return true;
  }

  bool RelaxStage(const ScoreGrid& grid, std::size_t s) {
    const Stage& stage = trellis_.stages[s];
    std::vector<double> onward = levels_[s + 1].best;
    for (std::size_t v = 0; v < onward.size(); ++v) {
      onward[v] += grid.Round(stage.nodes[v].reward);
    }
    const OnwardScores rest{onward.data(), static_cast<int>(onward.size()),
                            grid.shift()};
    const int nodes = NodesBefore(trellis_, s);
    ViterbiLevel& level = levels_[s];
    level.best.assign(nodes, kNone);
    costs_[s] = 0.0;
    std::size_t begin = 0;
    std::size_t length = 0;
    for (int u = 0; u < nodes; ++u, begin += length) {
      level.first_seam.push_back(static_cast<int>(begin));
      const std::size_t end = EndOfRow(stage.seams, u, begin, length);
      length = end - begin;
      if (length == 0) continue;
      const Seam* row = &stage.seams[begin];
      if (row->to < 0 || stage.seams[end - 1].to >= rest.nodes) return false;
      // Prefetch: the end of the next row is compared before that row is read.
      const std::size_t next_end = std::min(end + length, stage.seams.size());
      __builtin_prefetch(stage.seams.data() + next_end - 1);
      __builtin_prefetch(stage.seams.data() + next_end);
      const RowScan scan = ScanRow(row, static_cast<int>(end - begin), rest);
      if (!scan.sound) return false;
      level.best[u] = scan.best;
      costs_[s] = std::max(costs_[s], scan.largest_cost);
    }
    level.first_seam.push_back(static_cast<int>(begin));
    return begin == stage.seams.size();
  }

  // End of the seams from u, if they are in order; rows usually have equal
  // length.
  static std::size_t EndOfRow(const std::vector<Seam>& seams, int u,
                              std::size_t begin, std::size_t length) {
    const std::size_t likely = begin + length;
    if (length > 0 && likely <= seams.size() && seams[likely - 1].from == u &&
        (likely == seams.size() || seams[likely].from != u)) {
      return likely;
    }
    std::size_t end = begin;
    while (end < seams.size() && seams[end].from == u) ++end;
    return end;
  }

  const Trellis& trellis_;
  std::vector<double> rewards_;  // Largest reward and largest cost, by stage.
  std::vector<double> costs_;
  std::vector<ViterbiLevel> levels_;
};

}  // namespace

std::optional<PlainPass> PassPlain(const Trellis& trellis) {
  if (!IsPlain(trellis)) return std::nullopt;
  return PlainPasser(trellis).Pass();
}

}  // namespace kg_planner
