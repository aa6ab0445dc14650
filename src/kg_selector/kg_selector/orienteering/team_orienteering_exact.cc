// Exact choice from a pool of tours (team_orienteering.h).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "kg_selector/orienteering/team_orienteering.h"
#include "kg_selector/packing/packing.h"

namespace kg_selector {
namespace {

using kg_planner::OrienteeringProblem;
using kg_planner::PooledTour;
using kg_planner::Tour;
using kg_planner::TourSearch;

constexpr std::size_t kColumns = 300;  // Pool size of the team search.
// Pool size of planning under prices.
constexpr std::size_t kPricedColumns = 100;

// End of each part of a round, as a share of the round.
constexpr double kSearched = 0.80;
constexpr double kPriced = 0.86;
constexpr double kPacked = 0.92;
constexpr double kRound_s = 1.0;  // Approximate duration of a round [s].

class ExactTourTeam {
 public:
  ExactTourTeam(const OrienteeringProblem& problem,
                const TeamTourOptions& options)
      : problem_(problem),
        options_(options),
        budget_(options.seconds),
        all_(AllRewards(problem)),
        search_(problem, options.seed) {}

  TeamTours Plan() {
    const int rounds = std::max(
        1, static_cast<int>(std::lround(budget_.seconds() / kRound_s)));
    const double round_s = budget_.seconds() / rounds;
    for (int round = 0; round < rounds && !IsDone(); ++round) {
      Round(round * round_s, round_s);
    }
    TeamTours team;
    team.tours = search_.best();
    return team;
  }

 private:
  bool IsDone() const { return search_.reward() >= all_ - 1e-9; }

  void Round(double begin_s, double span_s) {
    // Step 1: search over all tours at once.
    RunCooled(budget_, {begin_s + kSearched * span_s}, all_, &search_);
    if (IsDone()) return;
    // Step 2: extend the pool by tours priced with the relaxation's duals.
    const std::vector<Tour> best = search_.best();
    Packing packing = Pool();
    AddPriced(begin_s + kPriced * span_s, &packing);
    // Step 3: set packing over the pool.
    const std::vector<Tour> chosen =
        Choose(packing, begin_s + kPacked * span_s);
    double value = 0.0;
    for (const Tour& tour : chosen) value += tour.reward;
    // Step 4: restart from the better team, at low tolerance.
    search_.Restart(value > search_.reward() ? chosen : best);
    RunCooled(budget_, {begin_s + span_s, 0.004, 0.001}, all_, &search_);
  }

  // Puts the best team's tours first, as the start of the packing.
  Packing Pool() {
    tours_.clear();
    for (const Tour& tour : search_.best()) {
      if (!tour.points.empty()) tours_.push_back(tour);
    }
    start_ = tours_.size();
    for (PooledTour& pooled : search_.pool(kColumns)) {
      tours_.push_back(std::move(pooled.tour));
    }
    Packing packing;
    packing.agent_counts = {problem_.tours};
    packing.row_capacities.assign(problem_.size(), 1);
    for (const Tour& tour : tours_) {
      packing.columns.push_back({0, tour.reward, tour.points});
    }
    return packing;
  }

  // Adds tours found when each point costs its row price in the pool.
  void AddPriced(double until_s, Packing* packing) {
    if (packing->columns.empty() || budget_.spent_s() >= until_s) return;
    const PackingPrices prices = PriceRows(*packing);
    std::vector<double> rewards = problem_.rewards;
    for (std::size_t p = 0; p < rewards.size(); ++p) {
      rewards[p] -= prices.rows[p];
    }
    const OrienteeringProblem alone = AloneWith(problem_, rewards);
    TourSearch search(alone, options_.seed);
    RunCooled(budget_, {until_s}, AllRewards(alone), &search);
    for (const PooledTour& pooled : search.pool(kPricedColumns)) {
      if (!(pooled.tour.reward > prices.agents[0] + 1e-9)) continue;
      Tour tour = kg_planner::MakeTour(problem_, pooled.tour.points);
      packing->columns.push_back({0, tour.reward, tour.points});
      tours_.push_back(std::move(tour));
    }
  }

  std::vector<Tour> Choose(const Packing& packing, double until_s) const {
    PackingOptions options;
    options.processor_time = true;
    options.time_limit_s = std::max(0.0, until_s - budget_.spent_s());
    for (std::size_t c = 0; c < start_; ++c) {
      options.start.push_back(static_cast<int>(c));
    }
    std::vector<Tour> chosen;
    for (int c : SolvePacking(packing, options).chosen) {
      chosen.push_back(tours_[c]);
    }
    return chosen;
  }

  const OrienteeringProblem& problem_;
  const TeamTourOptions& options_;
  const TimeBudget budget_;
  const double all_;
  TourSearch search_;
  std::vector<Tour> tours_;  // Tour of each column of the packing.
  std::size_t start_ = 0;    // Number of leading tours that form the best team.
};

}  // namespace

TeamTours PlanToursExactly(const OrienteeringProblem& problem,
                           const TeamTourOptions& options) {
  return ExactTourTeam(problem, options).Plan();
}

}  // namespace kg_selector
