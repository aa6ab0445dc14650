// Team orienteering in one window without flow: one agent per tour of the
// problem, all with the same start, end and length limit; each point is an
// event of capacity 1. The planner (kg_planner) computes tours; this unit
// coordinates them.
//
//   greedy    agents in turn: best tour, then its points are masked
//   auction   an outbid agent replans; taking a point from another raises
//             its price by epsilon, until no agent wants to change [1]; then
//             unheld points become free while that helps; finally each
//             replans around the others without prices
//   priced    all agents plan under common prices, which rise where
//             more than one agent goes and fall where none goes [2]
//   exact     a pool of tours from a search over all tours together and from
//             planning under the prices of the pool's rows; the best choice
//             from the pool by packing.h; the search resumes from it
//
// With prices p, and v(p) the best tour's reward minus prices, no team is worth
// more than agents v(p) + sum of p: an upper bound wherever v(p) is known
// exactly.
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
// Computes the tours of one team mode (team_modes.h).
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
  // Processor time of this thread, CBC included [s].
  double seconds = 0.5;
  unsigned seed = 1;
};

struct TeamTours {
  std::vector<kg_planner::Tour> tours;  // One per agent; may be empty.
  double value = 0.0;
  // Upper bound of the value; infinite = none known.
  double bound = std::numeric_limits<double>::infinity();
};

// Throws std::invalid_argument as kg_planner::Check() does, and if seconds are
// not finite and >= 0.
TeamTours PlanTours(const kg_planner::OrienteeringProblem& problem,
                    const TeamTourOptions& options);

// Checks tours against the problem only: too many, too long, a point repeated
// or out of range, a wrong value. Returns the first fault; "" = none.
std::string FindFault(const kg_planner::OrienteeringProblem& problem,
                      const TeamTours& team);

// ---- shared by the files of the modes

// Processor time of this thread since construction.
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

// Sum of the rewards of all points that can be visited.
double AllRewards(const kg_planner::OrienteeringProblem& problem);

// Runs the search until `until_s` of the budget while the tolerance falls from
// `hot` to `cold` (shares of the reward). Stops early once the search space is
// exhausted.
struct CoolingSchedule {
  double until_s = 0.0;
  double hot = 0.04;
  double cold = 0.004;
};
void RunCooled(const TimeBudget& budget, const CoolingSchedule& cooling,
               double all_rewards, kg_planner::TourSearch* search);

// The single-agent problem with these rewards.
kg_planner::OrienteeringProblem AloneWith(
    const kg_planner::OrienteeringProblem& problem,
    std::vector<double> rewards);

// Upper bound at these prices; infinite if the best tour is not proven optimal.
double BoundAt(const kg_planner::OrienteeringProblem& problem,
               const std::vector<double>& prices,
               const kg_planner::Tour& known);

}  // namespace kg_selector

#endif  // KG_SELECTOR_ORIENTEERING_TEAM_ORIENTEERING_H_
