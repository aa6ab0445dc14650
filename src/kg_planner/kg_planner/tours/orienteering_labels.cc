// Exact single tour of orienteering.h.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "kg_planner/tours/orienteering.h"

namespace kg_planner {
namespace {

constexpr std::size_t kWords = 4;  // Up to 256 useful points.

class PointSet {
 public:
  void Add(int point) { words_[point / 64] |= std::uint64_t{1} << point % 64; }
  bool Has(int point) const {
    return (words_[point / 64] >> point % 64 & 1) != 0;
  }
  bool IsWithin(const PointSet& other) const {
    for (std::size_t w = 0; w < kWords; ++w) {
      if ((words_[w] & ~other.words_[w]) != 0) return false;
    }
    return true;
  }

 private:
  std::array<std::uint64_t, kWords> words_{};
};

// Whether the triangle inequality holds.
bool IsMetric(const OrienteeringProblem& problem) {
  const double slack = 1e-12 * problem.limit;
  for (int i = 0; i < problem.size(); ++i) {
    for (int j = 0; j < problem.size(); ++j) {
      for (int k = 0; k < problem.size(); ++k) {
        if (problem.length(i, k) >
            problem.length(i, j) + problem.length(j, k) + slack) {
          return false;
        }
      }
    }
  }
  return true;
}

struct TourLabel {
  PointSet closed;  // Points visited or out of reach.
  double reward = 0.0;
  double length = 0.0;
  double bound = 0.0;  // Upper bound of tours with this prefix.
  int end = -1;        // Index of a useful point, -1 = the start.
  int before = -1;     // Index of the parent label.
  bool dominated = false;
};

class TourLabeling {
 public:
  TourLabeling(const OrienteeringProblem& problem, std::size_t max_labels,
               const Tour& known)
      : problem_(problem), max_labels_(max_labels) {
    const int last = problem.size() - 1;
    for (int p = 1; p < last; ++p) {
      const double length = problem.length(0, p) + problem.length(p, last);
      if (problem.rewards[p] > 0.0 && length <= problem.limit) {
        points_.push_back(p);
      }
    }
    at_end_.resize(points_.size());
    best_.tour = MakeTour(problem, known.points);
  }

  ExactTour Search() {
    best_.bound = 0.0;
    for (double reward : problem_.rewards) best_.bound += std::max(0.0, reward);
    if (points_.size() > 64 * kWords || !IsMetric(problem_)) return best_;
    TourLabel start;
    Bound(&start);
    labels_.push_back(start);
    open_.push({0.0, 0});
    while (!open_.empty()) {
      const int at = open_.top().second;
      open_.pop();
      if (!Extend(at)) return best_;
    }
    best_.proven = true;
    best_.bound = best_.tour.reward;
    return best_;
  }

 private:
  int PointAt(int end) const { return end < 0 ? 0 : points_[end]; }

  // Closes points out of reach and bounds the reward by the sum of the others.
  void Bound(TourLabel* label) const {
    const int last = problem_.size() - 1;
    label->bound = label->reward;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      if (label->closed.Has(i)) continue;
      const double length = label->length +
                            problem_.length(PointAt(label->end), points_[i]) +
                            problem_.length(points_[i], last);
      if (length <= problem_.limit) {
        label->bound += problem_.rewards[points_[i]];
      } else {
        label->closed.Add(i);
      }
    }
  }

  bool Extend(int at) {
    if (labels_[at].dominated || labels_[at].bound <= best_.tour.reward) {
      return true;
    }
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      // A copy: adding labels may move `labels_`.
      const TourLabel from = labels_[at];
      if (from.closed.Has(i)) continue;
      TourLabel to = from;
      to.length += problem_.length(PointAt(from.end), points_[i]);
      to.reward += problem_.rewards[points_[i]];
      to.end = i;
      to.before = at;
      const double length =
          to.length + problem_.length(points_[i], problem_.size() - 1);
      // The end must remain reachable.
      if (!(length <= problem_.limit)) continue;
      to.closed.Add(i);
      Bound(&to);
      if (!Add(to)) return false;
    }
    return true;
  }

  // False if there are too many.
  bool Add(const TourLabel& label) {
    for (int other : at_end_[label.end]) {
      if (Dominates(labels_[other], label)) return true;
    }
    for (int other : at_end_[label.end]) {
      if (Dominates(label, labels_[other])) labels_[other].dominated = true;
    }
    std::vector<int>& here = at_end_[label.end];
    here.erase(std::remove_if(here.begin(), here.end(),
                              [&](int l) { return labels_[l].dominated; }),
               here.end());
    if (labels_.size() >= max_labels_) return false;
    const int index = static_cast<int>(labels_.size());
    labels_.push_back(label);
    here.push_back(index);
    if (label.reward > best_.tour.reward) best_.tour = ToTour(index);
    if (label.bound > best_.tour.reward) open_.push({label.length, index});
    return true;
  }

  static bool Dominates(const TourLabel& a, const TourLabel& b) {
    return a.length <= b.length && a.reward >= b.reward &&
           a.closed.IsWithin(b.closed);
  }

  Tour ToTour(int index) const {
    std::vector<int> points;
    for (int l = index; labels_[l].end >= 0; l = labels_[l].before) {
      points.push_back(points_[labels_[l].end]);
    }
    std::reverse(points.begin(), points.end());
    return MakeTour(problem_, std::move(points));
  }

  const OrienteeringProblem& problem_;
  const std::size_t max_labels_;
  std::vector<int> points_;
  std::vector<TourLabel> labels_;
  std::vector<std::vector<int>> at_end_;  // Nondominated labels, by end point.
  using Item = std::pair<double, int>;    // Queue entry: shortest first.
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open_;
  ExactTour best_;
};

}  // namespace

std::optional<ExactTour> FindExactTour(const OrienteeringProblem& problem,
                                       std::size_t max_labels,
                                       const Tour& known) {
  Check(problem);
  if (!IsPossible(problem)) return std::nullopt;
  return TourLabeling(problem, max_labels, known).Search();
}

}  // namespace kg_planner
