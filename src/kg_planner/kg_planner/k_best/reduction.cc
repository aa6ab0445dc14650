#include "kg_planner/k_best/reduction.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace kg_planner {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

using Levels = std::vector<std::vector<double>>;

// Minimum resource use from the start to every node.
Levels LeastBefore(const SearchTrellis& search, std::size_t r) {
  Levels min_value{{0.0}};
  for (const SearchStage& stage : search.stages) {
    std::vector<double> next(stage.nodes, kNever);
    for (int i = 0; i < stage.seam_count; ++i) {
      const Seam& seam = stage.seams[i];
      next[seam.to] = std::min(
          next[seam.to], min_value.back()[seam.from] + stage.Resource(i, r));
    }
    min_value.push_back(std::move(next));
  }
  return min_value;
}

// Minimum resource use from every node to the end; level 0 = the start.
Levels LeastBehind(const SearchTrellis& search, std::size_t r) {
  const std::size_t stages = search.stages.size();
  Levels min_value(stages + 1);
  min_value[stages].assign(search.NodesBefore(stages), 0.0);
  for (std::size_t s = stages; s-- > 0;) {
    const SearchStage& stage = search.stages[s];
    min_value[s].assign(search.NodesBefore(s), kNever);
    for (int i = 0; i < stage.seam_count; ++i) {
      const Seam& seam = stage.seams[i];
      min_value[s][seam.from] =
          std::min(min_value[s][seam.from],
                   stage.Resource(i, r) + min_value[s + 1][seam.to]);
    }
  }
  return min_value;
}

template <typename Value>
void KeepValues(const std::vector<char>& keep, std::vector<Value>* values) {
  if (values->empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) (*values)[kept++] = (*values)[i];
  }
  values->resize(kept);
}

void KeepSeams(const std::vector<char>& keep, SearchStage* stage) {
  if (std::count(keep.begin(), keep.end(), 0) == 0) return;
  if (stage->origin.empty()) {
    stage->own.assign(stage->seams, stage->seams + stage->seam_count);
    for (int i = 0; i < stage->seam_count; ++i) stage->origin.push_back(i);
    stage->place = stage->origin;
  }
  KeepValues(keep, &stage->own);
  KeepValues(keep, &stage->origin);
  KeepValues(keep, &stage->place);
  KeepValues(keep, &stage->seam_gain);
  stage->UseOwn();
}

// A relative slack of 1e-9 covers rounding, because sums are formed in another
// order than a path's own.
void DropAbove(double limit, std::size_t r, SearchTrellis* search) {
  const Levels before = LeastBefore(*search, r);
  const Levels behind = LeastBehind(*search, r);
  const double max_value = limit < kNever ? limit + 1e-9 * std::max(limit, 0.0)
                                          : std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < search->stages.size(); ++s) {
    SearchStage& stage = search->stages[s];
    std::vector<char> keep(stage.seam_count);
    for (int i = 0; i < stage.seam_count; ++i) {
      const Seam& seam = stage.seams[i];
      keep[i] = before[s][seam.from] + stage.Resource(i, r) +
                    behind[s + 1][seam.to] <=
                max_value;
    }
    KeepSeams(keep, &stage);
  }
}

}  // namespace

void DropUnaffordable(const std::vector<double>& limits,
                      SearchTrellis* search) {
  for (std::size_t r = 0; r < limits.size(); ++r) {
    if (r == 0 || limits[r] < kNever) DropAbove(limits[r], r, search);
  }
}

}  // namespace kg_planner
