#include "kg_planner/tours/orienteering.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace kg_planner {

void Check(const OrienteeringProblem& problem) {
  const std::size_t size = problem.rewards.size();
  if (size < 2) throw std::invalid_argument("points: fewer than two");
  if (problem.lengths.size() != size * size) {
    throw std::invalid_argument("lengths: not one for each pair of points");
  }
  if (problem.tours < 1) throw std::invalid_argument("tours: fewer than one");
  if (!(problem.limit >= 0.0 && std::isfinite(problem.limit))) {
    throw std::invalid_argument("limit: not finite and >= 0");
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!std::isfinite(problem.rewards[i])) {
      throw std::invalid_argument("point " + std::to_string(i) +
                                  ": reward not finite");
    }
  }
  // Row-major: length i is from i / size to i % size.
  for (std::size_t i = 0; i < size * size; ++i) {
    if (!(problem.lengths[i] >= 0.0 && std::isfinite(problem.lengths[i]))) {
      throw std::invalid_argument(
          "length from point " + std::to_string(i / size) + " to " +
          std::to_string(i % size) + ": not finite and >= 0");
    }
  }
}

Tour MakeTour(const OrienteeringProblem& problem, std::vector<int> points) {
  Tour tour;
  int at = 0;
  for (int point : points) {
    tour.reward += problem.rewards[point];
    tour.length += problem.length(at, point);
    at = point;
  }
  tour.length += problem.length(at, problem.size() - 1);
  tour.points = std::move(points);
  return tour;
}

bool IsPossible(const OrienteeringProblem& problem) {
  return problem.length(0, problem.size() - 1) <= problem.limit;
}

}  // namespace kg_planner
