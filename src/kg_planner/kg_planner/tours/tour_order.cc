// TourSearch: reordering of tours.

#include <algorithm>

#include "kg_planner/tours/tour_search.h"

namespace kg_planner {
namespace {

constexpr double kLengthTolerance = 1e-9;  // Relative to the limit.

}  // namespace

bool TourSearch::Shorten() {
  bool shorter = false;
  for (int t = 0; t < problem_.tours; ++t) {
    if (touched_[t] == 0) continue;
    while (Reverse(t) || Move(t, 1) || Move(t, 2) || Move(t, 3)) shorter = true;
  }
  return shorter;
}

// 2-opt: reverses a run if that reduces the length.
bool TourSearch::Reverse(int tour) {
  std::vector<int>& p = now_.tours[tour];
  const int last = static_cast<int>(p.size()) - 1;
  const double min_value = kLengthTolerance * problem_.limit;
  for (int i = 1; i < last; ++i) {
    double forth = 0.0;
    double back = 0.0;
    for (int j = i + 1; j < last; ++j) {
      // Length of the run i..j in both directions, updated as j grows: lengths
      // may be asymmetric.
      forth += Length(p[j - 1], p[j]);
      back += Length(p[j], p[j - 1]);
      const double saved = Length(p[i - 1], p[i]) + forth +
                           Length(p[j], p[j + 1]) - Length(p[i - 1], p[j]) -
                           back - Length(p[i], p[j + 1]);
      if (!(saved > min_value)) continue;
      std::reverse(p.begin() + i, p.begin() + j + 1);
      now_.lengths[tour] -= saved;
      return true;
    }
  }
  return false;
}

// Or-opt: moves a run of `count` points if that reduces the length.
bool TourSearch::Move(int tour, int count) {
  std::vector<int>& p = now_.tours[tour];
  const int last = static_cast<int>(p.size()) - 1;
  const double min_value = kLengthTolerance * problem_.limit;
  for (int i = 1; i + count <= last; ++i) {
    const int j = i + count;  // The run is [i, j).
    // Saving of removing the run, then cost of inserting it before k.
    const double closed = Length(p[i - 1], p[i]) + Length(p[j - 1], p[j]) -
                          Length(p[i - 1], p[j]);
    if (!(closed > min_value)) continue;
    for (int k = 1; k <= last; ++k) {
      if (k >= i && k <= j) continue;
      const double opened = Length(p[k - 1], p[i]) + Length(p[j - 1], p[k]) -
                            Length(p[k - 1], p[k]);
      if (!(closed - opened > min_value)) continue;
      const auto begin = p.begin();
      if (k < i) std::rotate(begin + k, begin + i, begin + j);
      if (k > j) std::rotate(begin + i, begin + j, begin + k);
      now_.lengths[tour] -= closed - opened;
      return true;
    }
  }
  return false;
}

}  // namespace kg_planner
