#include "kg_planner/tours/micro_labels.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace kg_planner {
namespace {

struct MicroLabel {
  // Ascending; the key together with the path's last node.
  std::vector<int> set;
  MicroPath path;
  int end() const { return path.nodes.back(); }
};

bool SameKey(const MicroLabel& a, const MicroLabel& b) {
  return a.end() == b.end() && a.set == b.set;
}

bool ByKeyThenOrder(const MicroLabel& a, const MicroLabel& b) {
  const int a_end = a.end();
  const int b_end = b.end();
  if (std::tie(a_end, a.set) != std::tie(b_end, b.set)) {
    return std::tie(a_end, a.set) < std::tie(b_end, b.set);
  }
  return BetterOrder(a.path, b.path);
}

bool LabelsByEndThenScore(const MicroLabel& a, const MicroLabel& b) {
  if (a.end() != b.end()) return a.end() < b.end();
  const double a_score = a.path.score();
  const double b_score = b.path.score();
  if (a_score != b_score) return a_score > b_score;
  return BetterOrder(a.path, b.path);
}

class LabelSetting {
 public:
  LabelSetting(const MicroGraph& graph, const LabelOptions& options)
      : graph_(graph), options_(options) {}

  LabelSearch Search() {
    std::vector<MicroLabel> level;
    MicroLabel entry;
    Extend(entry, -1, &level);
    for (int nodes = 1; !level.empty() && !stopped_; ++nodes) {
      DropDominated(&level);
      Collect(level);
      if (nodes == options_.max_nodes) break;
      if (options_.beam > 0) CutToBeam(&level);
      std::vector<MicroLabel> next;
      for (const MicroLabel& label : level) {
        if (TimeIsUp()) stopped_ = true;
        Extend(label, label.end(), &next);
      }
      level = std::move(next);
    }
    search_.complete = search_.complete && !stopped_;
    return std::move(search_);
  }

 private:
  bool TimeIsUp() const {
    return options_.deadline != std::chrono::steady_clock::time_point::max() &&
           std::chrono::steady_clock::now() >= options_.deadline;
  }

  void Extend(const MicroLabel& label, int at, std::vector<MicroLabel>* next) {
    if (stopped_) return;
    for (const Leg* leg = graph_.begin(at); leg != graph_.end(at); ++leg) {
      const double duration = label.path.duration + leg->duration;
      if (!(duration <= graph_.duration_limit())) continue;
      const auto place =
          std::lower_bound(label.set.begin(), label.set.end(), leg->to);
      if (place != label.set.end() && *place == leg->to) continue;
      // Counted whether or not it will be dominated: the count bounds time.
      if (++made_ > options_.max_labels) {
        stopped_ = true;
        return;
      }
      MicroLabel longer = label;
      longer.set.insert(longer.set.begin() + (place - label.set.begin()),
                        leg->to);
      longer.path.nodes.push_back(leg->to);
      longer.path.reward = graph_.TotalReward(longer.set);
      longer.path.cost += leg->cost;
      longer.path.resource += leg->resource;
      longer.path.duration = duration;
      next->push_back(std::move(longer));
    }
  }

  // Sorted by cost within a key, so a label is dominated unless it is quicker
  // than all before it.
  static void DropDominated(std::vector<MicroLabel>* level) {
    std::sort(level->begin(), level->end(), ByKeyThenOrder);
    std::vector<MicroLabel> kept;
    double quickest = std::numeric_limits<double>::infinity();
    for (MicroLabel& label : *level) {
      const bool first = kept.empty() || !SameKey(kept.back(), label);
      if (!first && !(label.path.duration < quickest)) continue;
      quickest = label.path.duration;
      kept.push_back(std::move(label));
    }
    *level = std::move(kept);
  }

  void Collect(const std::vector<MicroLabel>& level) {
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (i > 0 && SameKey(level[i - 1], level[i])) continue;
      search_.paths.push_back(level[i].path);
    }
  }

  // Keeps the best labels of each end, and the quickest: it may reach nodes
  // that no other can.
  void CutToBeam(std::vector<MicroLabel>* level) {
    std::sort(level->begin(), level->end(), LabelsByEndThenScore);
    std::vector<MicroLabel> kept;
    for (std::size_t begin = 0, end = 0; begin < level->size(); begin = end) {
      while (end < level->size() &&
             (*level)[end].end() == (*level)[begin].end()) {
        ++end;
      }
      const std::size_t cut = std::min(end, begin + options_.beam);
      const auto first = level->begin();
      // The quickest is kept beyond the beam: only it may still have time for
      // another node.
      const auto quickest =
          std::min_element(first + begin, first + end,
                           [](const MicroLabel& a, const MicroLabel& b) {
                             return a.path.duration < b.path.duration;
                           });
      const bool quickest_is_cut = quickest >= first + cut;
      search_.complete = search_.complete && cut == end;
      if (quickest_is_cut) kept.push_back(*quickest);
      std::move(first + begin, first + cut, std::back_inserter(kept));
    }
    *level = std::move(kept);
  }

  const MicroGraph& graph_;
  const LabelOptions& options_;
  std::size_t made_ = 0;
  bool stopped_ = false;
  LabelSearch search_;
};

}  // namespace

LabelSearch SearchLabels(const MicroGraph& graph, const LabelOptions& options) {
  return LabelSetting(graph, options).Search();
}

}  // namespace kg_planner
