#include "kg_selector/orienteering/team_orienteering.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <set>
#include <stdexcept>
#include <utility>

namespace kg_selector {
namespace {

using kg_planner::OrienteeringProblem;
using kg_planner::Tour;
using kg_planner::TourSearch;

constexpr std::size_t kSteps = 50;  // Search steps between clock reads.
constexpr std::size_t kMaxLabels = 20000;

double ThreadNow_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * now.tv_nsec;
}

double TotalReward(const OrienteeringProblem& problem,
                   const std::vector<Tour>& tours) {
  double value = 0.0;
  for (const Tour& tour : tours) {
    for (int point : tour.points) value += problem.rewards[point];
  }
  return value;
}

}  // namespace

TimeBudget::TimeBudget(double seconds)
    : seconds_(seconds), begin_s_(ThreadNow_s()) {}

double TimeBudget::spent_s() const { return ThreadNow_s() - begin_s_; }

double AllRewards(const OrienteeringProblem& problem) {
  const int last = problem.size() - 1;
  double sum = 0.0;
  for (int p = 1; p < last; ++p) {
    const double length = problem.length(0, p) + problem.length(p, last);
    if (length <= problem.limit) sum += std::max(0.0, problem.rewards[p]);
  }
  return sum;
}

void RunCooled(const TimeBudget& budget, const CoolingSchedule& cooling,
               double all_rewards, TourSearch* search) {
  const double begin_s = budget.spent_s();
  const double span_s = cooling.until_s - begin_s;
  double done = 0.0;
  while (done < 1.0 && search->reward() < all_rewards - 1e-9) {
    const double share =
        cooling.hot * std::pow(cooling.cold / cooling.hot, done);
    search->Run(kSteps, share * search->reward());
    done = span_s > 0.0 ? (budget.spent_s() - begin_s) / span_s : 1.0;
  }
}

OrienteeringProblem AloneWith(const OrienteeringProblem& problem,
                              std::vector<double> rewards) {
  OrienteeringProblem alone = problem;
  alone.rewards = std::move(rewards);
  alone.tours = 1;
  return alone;
}

double BoundAt(const OrienteeringProblem& problem,
               const std::vector<double>& prices, const Tour& known) {
  std::vector<double> rewards = problem.rewards;
  double sum = 0.0;
  for (std::size_t p = 0; p < rewards.size(); ++p) {
    rewards[p] -= prices[p];
    sum += prices[p];
  }
  const auto best =
      kg_planner::FindExactTour(AloneWith(problem, rewards), kMaxLabels, known);
  if (!best) return 0.0;  // No tour is possible.
  if (!best->proven) return std::numeric_limits<double>::infinity();
  return problem.tours * best->tour.reward + sum;
}

TeamTours PlanToursGreedily(const OrienteeringProblem& problem,
                            const TeamTourOptions& options) {
  const TimeBudget budget(options.seconds);
  TeamTours team;
  std::vector<double> rewards = problem.rewards;
  for (int agent = 0; agent < problem.tours; ++agent) {
    const OrienteeringProblem alone = AloneWith(problem, rewards);
    TourSearch search(alone, options.seed);
    CoolingSchedule cooling;
    cooling.until_s = budget.seconds() * (agent + 1) / problem.tours;
    RunCooled(budget, cooling, AllRewards(alone), &search);
    team.tours.push_back(search.best()[0]);
    for (int point : team.tours.back().points) rewards[point] = 0.0;
  }
  return team;
}

TeamTours PlanTours(const OrienteeringProblem& problem,
                    const TeamTourOptions& options) {
  kg_planner::Check(problem);
  if (!(options.seconds >= 0.0 && std::isfinite(options.seconds))) {
    throw std::invalid_argument("seconds: not finite and >= 0");
  }
  if (!kg_planner::IsPossible(problem)) return {{}, 0.0, 0.0};
  TeamTours team = options.planner(problem, options);
  team.value = TotalReward(problem, team.tours);
  // Up to rounding, a value does not exceed its bound.
  const double bound = std::min(team.bound, AllRewards(problem));
  const bool known = std::isfinite(team.bound) || team.value >= bound - 1e-9;
  team.bound = known ? std::max(bound, team.value)
                     : std::numeric_limits<double>::infinity();
  return team;
}

std::string FindFault(const OrienteeringProblem& problem,
                      const TeamTours& team) {
  if (static_cast<int>(team.tours.size()) > problem.tours) {
    return "more tours than agents";
  }
  std::set<int> seen;
  double value = 0.0;
  for (const Tour& tour : team.tours) {
    double length = 0.0;
    int at = 0;
    for (int point : tour.points) {
      // Start and end are not visitable points.
      const std::string name = "point " + std::to_string(point);
      if (point <= 0 || point + 1 >= problem.size()) return name + ": none";
      if (!seen.insert(point).second) return name + ": visited twice";
      length += problem.length(at, point);
      value += problem.rewards[point];
      at = point;
    }
    length += problem.length(at, problem.size() - 1);
    if (!tour.points.empty() && !(length <= problem.limit)) {
      return "a tour of length " + std::to_string(length) +
             " above the limit of " + std::to_string(problem.limit);
    }
  }
  // Sums in another order differ by rounding.
  if (!(std::abs(value - team.value) <= 1e-9 * (1.0 + value))) {
    return "a value that is not that of its tours";
  }
  return "";
}

}  // namespace kg_selector
