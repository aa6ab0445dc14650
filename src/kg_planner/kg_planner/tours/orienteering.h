// Orienteering: tours from a start to an end, each within a limit of length,
// that collect the rewards of the points they visit. One tour, or several of
// the same start, end and limit, each point on at most one of them.
//
//   maximise  sum of rewards of the points visited
//   such that the length of every tour is at most `limit`
//
// Prices on points are taken off rewards by the caller; a point of reward 0 or
// less is never visited.
//
//   ExactTour     the best single tour, by labels, if it is found within a
//                 number of labels (orienteering_labels.cc)
//   TourSearch    anytime: destroy and repair with simulated acceptance, and a
//                 pool of the good tours met (tour_search.h)
//
// Nothing here looks at a clock: callers count labels and steps.

#ifndef KG_PLANNER_TOURS_ORIENTEERING_H_
#define KG_PLANNER_TOURS_ORIENTEERING_H_

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace kg_planner {

struct OrienteeringProblem {
  std::vector<double> rewards;  // By point. 0 is the start, the last the end.
  std::vector<double> lengths;  // From point to point, row by row; >= 0.
  double limit = 0.0;           // >= 0.
  int tours = 1;                // >= 1.

  int size() const { return static_cast<int>(rewards.size()); }
  double length(int from, int to) const {
    return lengths[static_cast<std::size_t>(from) * rewards.size() + to];
  }
};

struct Tour {
  std::vector<int> points;  // In order, without start and end.
  double reward = 0.0;
  double length = 0.0;  // From the start, through the points, to the end.
};

// Throws std::invalid_argument that names the point if there are fewer than two
// points, lengths are not the square of their number, a number is not finite, a
// length is negative, or there is no tour to make.
void Check(const OrienteeringProblem& problem);

// Through `points` in this order.
Tour MakeTour(const OrienteeringProblem& problem, std::vector<int> points);

// Is the end within the limit from the start?
bool IsPossible(const OrienteeringProblem& problem);

struct ExactTour {
  Tour tour;            // The best found.
  bool proven = false;  // It is the best there is.
  // No tour has more; all that there is, if not proven.
  double bound = std::numeric_limits<double>::infinity();
};
// The best single tour (`tours` is not read). Labels over the set visited and
// the end: one is dominated by another of its end that is no longer, has no
// less reward, and has visited nothing that the first has not (or cannot visit
// any more). Gives up after `max_labels`, beyond 256 points worth visiting, and
// at once where a detour may be a short cut; `known` is a tour to start from.
// Nothing if the end is not within the limit from the start.
std::optional<ExactTour> FindExactTour(const OrienteeringProblem& problem,
                                       std::size_t max_labels,
                                       const Tour& known = {});

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_ORIENTEERING_H_
