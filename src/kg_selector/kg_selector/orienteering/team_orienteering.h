// Teams in one window without flow: as many agents as the problem has tours,
// all with the same start, end and limit, each point an event of capacity 1.
// The planner (kg_planner) makes tours, here they are coordinated.
//
//   greedy    the best tour alone, its points masked, the next agent
//   auction   who is outbid plans again; to take a point from another raises
//             its price by epsilon, until nobody wants to change [1]; then what
//             nobody holds is free again, as long as that pays; last, each
//             plans around the others without prices
//   priced    prices are broadcast, all plan under them, and they rise where
//             more than one agent goes and fall where none does [2]
//   exact     a pool of tours from a search over all tours together and from
//             planning under the prices of the pool's rows; of the pool the
//             best choice by packing.h; the search goes on from it
//
// With prices p and v(p) the best tour's reward less prices, no team has more
// than  agents v(p) + sum of p: a bound wherever v(p) is known exactly.
//
// [1] D. P. Bertsekas, "Auction algorithms for network flow problems: A
//     tutorial introduction", Computational Optimization and Applications 1
//     (1992), 7-66.
// [2] M. L. Fisher, "The Lagrangian Relaxation Method for Solving Integer
//     Programming Problems", Management Science 27 (1981), 1-18.

#ifndef KG_SELECTOR_ORIENTEERING_TEAM_ORIENTEERING_H_
#define KG_SELECTOR_ORIENTEERING_TEAM_ORIENTEERING_H_

#include <limits>
#include <string>
#include <vector>

#include "kg_planner/tours/orienteering.h"
#include "kg_planner/tours/tour_search.h"

namespace kg_selector {

struct TeamTourOptions;
struct TeamTours;
// Makes the tours of one team mode (team_modes.h).
using TourPlanner =
    TeamTours (*)(const kg_planner::OrienteeringProblem& problem,
                  const TeamTourOptions& options);

TeamTours PlanToursGreedily(const kg_planner::OrienteeringProblem& problem,
                            const TeamTourOptions& options);
TeamTours PlanToursByAuction(const kg_planner::OrienteeringProblem& problem,
                             const TeamTourOptions& options);
TeamTours PlanToursByPrices(const kg_planner::OrienteeringProblem& problem,
                            const TeamTourOptions& options);
TeamTours PlanToursExactly(const kg_planner::OrienteeringProblem& problem,
                           const TeamTourOptions& options);

struct TeamTourOptions {
  TourPlanner planner = PlanToursExactly;
  // Of this thread's processor, CBC's part included.
  double seconds = 0.5;
  unsigned seed = 1;
};

struct TeamTours {
  std::vector<kg_planner::Tour> tours;  // One an agent; may be empty.
  double value = 0.0;
  // No team has more; infinite: none is known.
  double bound = std::numeric_limits<double>::infinity();
};

// Throws std::invalid_argument as kg_planner::Check() does, and if seconds are
// not finite and >= 0.
TeamTours PlanTours(const kg_planner::OrienteeringProblem& problem,
                    const TeamTourOptions& options);

// What is wrong with these tours: too many, too long, a point twice or not
// there, a value that is not theirs. Reads nothing but the problem. "" = none.
std::string FindFault(const kg_planner::OrienteeringProblem& problem,
                      const TeamTours& team);

// ---- parts, by mode in files of their own

// Processor time of this thread from now on.
class TimeBudget {
 public:
  explicit TimeBudget(double seconds);
  double spent_s() const;
  double left_s() const { return seconds_ - spent_s(); }
  double seconds() const { return seconds_; }

 private:
  double seconds_ = 0.0;
  double begin_s_ = 0.0;
};

// What all points that can be visited are worth together.
double AllRewards(const kg_planner::OrienteeringProblem& problem);

// Runs the search until `until_s` of the budget, the tolerance falling from
// `hot` to `cold` (shares of the reward); less if all there is was found.
struct CoolingSchedule {
  double until_s = 0.0;
  double hot = 0.04;
  double cold = 0.004;
};
void RunCooled(const TimeBudget& budget, const CoolingSchedule& cooling,
               double all_rewards, kg_planner::TourSearch* search);

// The problem of one agent, with these rewards.
kg_planner::OrienteeringProblem AloneWith(
    const kg_planner::OrienteeringProblem& problem,
    std::vector<double> rewards);

// The bound at these prices, infinite if the best tour is not proven.
double BoundAt(const kg_planner::OrienteeringProblem& problem,
               const std::vector<double>& prices,
               const kg_planner::Tour& known);

}  // namespace kg_selector

#endif  // KG_SELECTOR_ORIENTEERING_TEAM_ORIENTEERING_H_
