// Orienteering: tours from a start to an end, each within a length limit, that
// collect the rewards of the points they visit. One tour, or several with the
// same start, end and limit, each point on at most one of them.
//
//   maximise  sum of rewards of the points visited
//   such that the length of every tour is at most `limit`
//
// The caller subtracts prices of points from rewards; a point with reward <= 0
// is never visited.
//
//   ExactTour     the best single tour, by label setting within a maximum
//                 number of labels (orienteering_labels.cc)
//   TourSearch    anytime: destroy and repair with randomised acceptance, and a
//                 pool of good tours (tour_search.h)
//
// No unit here reads a clock: callers limit labels and steps.

#ifndef KG_PLANNER_TOURS_ORIENTEERING_H_
#define KG_PLANNER_TOURS_ORIENTEERING_H_

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace kg_planner {

struct OrienteeringProblem {
  std::vector<double> rewards;  // By point; 0 is the start, the last the end.
  // Row-major matrix of lengths from row to column; >= 0.
  std::vector<double> lengths;
  double limit = 0.0;  // >= 0.
  int tours = 1;       // >= 1.

  int size() const { return static_cast<int>(rewards.size()); }
  double length(int from, int to) const {
    return lengths[static_cast<std::size_t>(from) * rewards.size() + to];
  }
};

struct Tour {
  std::vector<int> points;  // In order, without start and end.
  double reward = 0.0;
  double length = 0.0;  // Length from start to end through the points.
};

// Throws std::invalid_argument naming the point if there are fewer than two
// points, `lengths` is not square, a number is not finite, a length is
// negative, or `tours` is below 1.
void Check(const OrienteeringProblem& problem);

// Tour through `points` in this order.
Tour MakeTour(const OrienteeringProblem& problem, std::vector<int> points);

// Whether the end is within the limit from the start.
bool IsPossible(const OrienteeringProblem& problem);

struct ExactTour {
  Tour tour;            // Best tour found.
  bool proven = false;  // Proven optimal.
  // Upper bound of the reward; the sum of all rewards if not proven.
  double bound = std::numeric_limits<double>::infinity();
};
// The best single tour (`tours` is ignored). Labels over (set visited, end): a
// label is dominated by another with the same end that is no longer, has no
// less reward, and whose visited points are also visited (or out of reach) in
// the first. Stops after `max_labels`, above 256 useful points, and at once if
// lengths violate the triangle inequality; `known` is an initial tour. Nullopt
// if the end is not within the limit from the start.
std::optional<ExactTour> FindExactTour(const OrienteeringProblem& problem,
                                       std::size_t max_labels,
                                       const Tour& known = {});

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_ORIENTEERING_H_
