// TourSearch: removal of points.

#include <algorithm>

#include "kg_planner/tours/tour_search.h"

namespace kg_planner {

int TourSearch::Visited() const {
  int visited = 0;
  for (const auto& tour : now_.tours) {
    visited += static_cast<int>(tour.size()) - 2;
  }
  return visited;
}

void TourSearch::Destroy() {
  const int visited = Visited();
  if (visited == 0) return;
  const int max_value = std::min(visited, 4 + visited / 2);
  const int points = 1 + static_cast<int>(RandomBelow(max_value));
  if (RandomBelow(3) > 0) {
    RemoveStrings(points);
  } else {
    RemoveSingles(points);
  }
}

void TourSearch::RemoveRun(int tour, int begin, int count) {
  std::vector<int>& points = now_.tours[tour];
  double gone = 0.0;
  for (int i = begin; i < begin + count; ++i) {
    gone += Length(points[i - 1], points[i]);
    tour_of_[points[i]] = -1;
    now_.reward -= problem_.rewards[points[i]];
  }
  gone += Length(points[begin + count - 1], points[begin + count]);
  now_.lengths[tour] += Length(points[begin - 1], points[begin + count]) - gone;
  points.erase(points.begin() + begin, points.begin() + begin + count);
  touched_[tour] = 1;
}

// String removal around a random point: a string from each nearby tour, until
// `points` points are removed.
void TourSearch::RemoveStrings(int points) {
  const int around =
      useful_[RandomBelow(static_cast<std::uint32_t>(useful_.size()))];
  std::vector<char> done(now_.tours.size(), 0);
  for (int p : near_[around]) {
    if (points <= 0) break;
    const int t = tour_of_[p];
    if (t < 0 || done[t] != 0) continue;
    done[t] = 1;
    const auto& tour = now_.tours[t];
    // A string of random length that contains p, limited by the tour's length.
    const int inner = static_cast<int>(tour.size()) - 2;
    const int count =
        1 + static_cast<int>(RandomBelow(std::min(inner, points)));
    const int at =
        static_cast<int>(std::find(tour.begin(), tour.end(), p) - tour.begin());
    const int first = std::max(1, at - count + 1);
    const int last = std::min(at, inner - count + 1);
    RemoveRun(t, first + static_cast<int>(RandomBelow(last - first + 1)),
              count);
    points -= count;
  }
}

void TourSearch::RemoveSingles(int points) {
  for (; points > 0; --points) {
    const int visited = Visited();
    if (visited == 0) return;
    int pick = static_cast<int>(RandomBelow(visited));
    int t = 0;
    while (pick >= static_cast<int>(now_.tours[t].size()) - 2) {
      pick -= static_cast<int>(now_.tours[t].size()) - 2;
      ++t;
    }
    RemoveRun(t, pick + 1, 1);
  }
}

}  // namespace kg_planner
