// The part of TourSearch that puts tours in better order.

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

// Reverses a run if that saves length.
bool TourSearch::Reverse(int tour) {
  std::vector<int>& p = now_.tours[tour];
  const int last = static_cast<int>(p.size()) - 1;
  const double min_value = kLengthTolerance * problem_.limit;
  for (int i = 1; i < last; ++i) {
    double forth = 0.0;
    double back = 0.0;
    for (int j = i + 1; j < last; ++j) {
      // Length of the run i..j in both directions, kept up as j grows: lengths
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

// Moves a run of `count` points if that saves length.
bool TourSearch::Move(int tour, int count) {
  std::vector<int>& p = now_.tours[tour];
  const int last = static_cast<int>(p.size()) - 1;
  const double min_value = kLengthTolerance * problem_.limit;
  for (int i = 1; i + count <= last; ++i) {
    const int j = i + count;  // The run is [i, j).
    // What is saved by taking the run out, then what putting it in before k
    // costs.
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
