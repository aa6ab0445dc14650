// Teams by auction and by Lagrangian prices (team_orienteering.h).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <numeric>
#include <utility>

#include "kg_selector/orienteering/team_orienteering.h"

namespace kg_selector {
namespace {

using kg_planner::OrienteeringProblem;
using kg_planner::Tour;
using kg_planner::TourSearch;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = 0.1;  // Minimum price increment / mean reward.
constexpr int kChunks = 6;        // Step chunks for one agent's tour.
constexpr std::size_t kChunkSteps = 40;
constexpr double kBoundShare = 0.15;  // Share of the time kept for the bound.
constexpr int kMaxFailedRounds = 8;   // Rounds before a smaller step.

double Sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// One agent's best tour for these rewards, improved from `from`.
Tour PlanAlone(const OrienteeringProblem& problem,
               const std::vector<double>& rewards, const Tour& from,
               unsigned seed) {
  const OrienteeringProblem alone = AloneWith(problem, rewards);
  TourSearch search(alone, seed);
  if (!from.points.empty()) {
    search.Restart({kg_planner::MakeTour(alone, from.points)});
  }
  double share = 0.04;
  for (int chunk = 0; chunk < kChunks; ++chunk, share *= 0.6) {
    search.Run(kChunkSteps, share * search.reward());
  }
  return search.best()[0];
}

double Worth(const std::vector<double>& rewards, const Tour& tour) {
  double worth = 0.0;
  for (int point : tour.points) worth += rewards[point];
  return worth;
}

// Agents replan in turn around the others, without prices.
double PlanAround(const OrienteeringProblem& problem, unsigned seed,
                  std::vector<Tour>* tours) {
  std::vector<double> left = problem.rewards;
  for (const Tour& tour : *tours) {
    for (int point : tour.points) left[point] = 0.0;
  }
  double value = 0.0;
  for (Tour& tour : *tours) {
    for (int point : tour.points) left[point] = problem.rewards[point];
    tour = PlanAlone(problem, left, tour, seed);
    for (int point : tour.points) left[point] = 0.0;
    value += Worth(problem.rewards, tour);
  }
  return value;
}

class TourAuction {
 public:
  TourAuction(const OrienteeringProblem& problem,
              const TeamTourOptions& options)
      : problem_(problem),
        options_(options),
        budget_(options.seconds),
        prices_(problem.size(), 0.0),
        holders_(problem.size(), -1),
        tours_(problem.tours) {
    double sum = 0.0;
    int count = 0;
    for (double reward : problem.rewards) {
      if (!(reward > 0.0)) continue;
      sum += reward;
      ++count;
    }
    epsilon_ = count > 0 ? kEpsilon * sum / count : 1.0;
  }

  TeamTours Run() {
    TeamTours best;
    do {
      RunBids();
      std::vector<Tour> tours = tours_;
      const double value = PlanAround(problem_, options_.seed, &tours);
      best.bound =
          std::min(best.bound, BoundAt(problem_, prices_, tours_.front()));
      if (best.tours.empty() || value > best.value) {
        best.value = value;
        best.tours = std::move(tours);
      } else {
        break;
      }
    } while (FreePrices() && budget_.spent_s() < Until_s());
    return best;
  }

 private:
  double Until_s() const { return (1.0 - kBoundShare) * budget_.seconds(); }

  // Bids until no agent wants to change.
  void RunBids() {
    std::deque<int> bidders(problem_.tours);
    std::iota(bidders.begin(), bidders.end(), 0);
    while (!bidders.empty() && budget_.spent_s() < Until_s()) {
      const int agent = bidders.front();
      bidders.pop_front();
      Bid(agent, &bidders);
    }
  }

  // Resets the prices of unheld points to 0. False if there are none.
  bool FreePrices() {
    bool any = false;
    for (int p = 0; p < problem_.size(); ++p) {
      if (holders_[p] >= 0 || prices_[p] <= 0.0) continue;
      prices_[p] = 0.0;
      any = true;
    }
    return any;
  }

  // Rewards minus the price of the points to this agent.
  std::vector<double> NetRewards(int agent) const {
    std::vector<double> net = problem_.rewards;
    for (int p = 0; p < problem_.size(); ++p) {
      const bool of_another = holders_[p] >= 0 && holders_[p] != agent;
      net[p] -= prices_[p] + (of_another ? epsilon_ : 0.0);
    }
    return net;
  }

  void Bid(int agent, std::deque<int>* bidders) {
    const std::vector<double> net = NetRewards(agent);
    const Tour wanted = PlanAlone(problem_, net, tours_[agent], options_.seed);
    if (!(Worth(net, wanted) > Worth(net, tours_[agent]) + 1e-9)) return;
    for (int point : tours_[agent].points) holders_[point] = -1;
    for (int point : wanted.points) {
      const int loser = std::exchange(holders_[point], agent);
      if (loser < 0) continue;
      prices_[point] += epsilon_;
      LosePoint(loser, point);
      if (std::find(bidders->begin(), bidders->end(), loser) ==
          bidders->end()) {
        bidders->push_back(loser);
      }
    }
    tours_[agent] = kg_planner::MakeTour(problem_, wanted.points);
  }

  void LosePoint(int agent, int point) {
    std::vector<int> points = tours_[agent].points;
    points.erase(std::remove(points.begin(), points.end(), point),
                 points.end());
    tours_[agent] = kg_planner::MakeTour(problem_, std::move(points));
    if (tours_[agent].length <= problem_.limit) return;
    // Lengths need not be a metric: without the point the tour may become too
    // long. The agent restarts from an empty tour.
    for (int held : tours_[agent].points) holders_[held] = -1;
    tours_[agent] = {};
  }

  const OrienteeringProblem& problem_;
  const TeamTourOptions& options_;
  const TimeBudget budget_;
  double epsilon_ = 1.0;
  std::vector<double> prices_;
  std::vector<int> holders_;  // Agent holding each point; -1 = none.
  std::vector<Tour> tours_;   // Tour of each agent.
};

class TourPricing {
 public:
  TourPricing(const OrienteeringProblem& problem,
              const TeamTourOptions& options)
      : problem_(problem),
        options_(options),
        budget_(options.seconds),
        prices_(problem.size(), 0.0) {}

  TeamTours Run() {
    do {
      Round();
    } while (budget_.left_s() > 0.0 && !IsClosed());
    return best_;
  }

 private:
  bool IsClosed() const {
    const double all = AllRewards(problem_);
    return best_.value >= std::min(best_.bound, all) - 1e-9;
  }

  void Round() {
    std::vector<double> net = problem_.rewards;
    for (int p = 0; p < problem_.size(); ++p) net[p] -= prices_[p];
    // Agents are identical: under common prices all want the same tour.
    const Tour wanted = PlanAlone(problem_, net, {}, options_.seed + rounds_++);
    const double value = problem_.tours * wanted.reward + Sum(prices_);
    if (provable_) {
      const double bound = BoundAt(problem_, prices_, wanted);
      provable_ = std::isfinite(bound);
      best_.bound = std::min(best_.bound, bound);
    }
    Assign(net, wanted);
    MovePrices(wanted, value);
  }

  // Feasible team: the first agent gets its tour, the others plan around it
  // under the same prices; then each replans for what is left, without prices.
  void Assign(std::vector<double> net, const Tour& wanted) {
    std::vector<Tour> tours;
    for (int agent = 0; agent < problem_.tours; ++agent) {
      Tour tour =
          agent == 0 ? wanted : PlanAlone(problem_, net, {}, options_.seed);
      for (int point : tour.points) net[point] = 0.0;
      tours.push_back(kg_planner::MakeTour(problem_, tour.points));
    }
    const double value = PlanAround(problem_, options_.seed, &tours);
    if (!(value > best_.value)) return;
    best_.value = value;
    best_.tours = std::move(tours);
  }

  // Subgradient step, scaled by the gap between value and best team (Polyak).
  void MovePrices(const Tour& wanted, double value) {
    if (value < least_ - 1e-9) {
      least_ = value;
      failed_rounds_ = 0;
    } else if (++failed_rounds_ == kMaxFailedRounds) {
      share_ *= 0.5;
      failed_rounds_ = 0;
    }
    // Subgradient: visitors (all agents want the same tour) less the capacity
    // of 1. A price of 0 cannot fall.
    std::vector<double> excess(problem_.size(), -1.0);
    for (int point : wanted.points) excess[point] += problem_.tours;
    double square = 0.0;
    for (int p = 0; p < problem_.size(); ++p) {
      if (prices_[p] <= 0.0 && excess[p] < 0.0) excess[p] = 0.0;
      square += excess[p] * excess[p];
    }
    if (square == 0.0) return;
    const double step = share_ * std::max(0.0, value - best_.value) / square;
    for (int p = 0; p < problem_.size(); ++p) {
      prices_[p] = std::max(0.0, prices_[p] + step * excess[p]);
    }
  }

  const OrienteeringProblem& problem_;
  const TeamTourOptions& options_;
  const TimeBudget budget_;
  std::vector<double> prices_;
  TeamTours best_;
  unsigned rounds_ = 0;
  bool provable_ = true;      // All best tours so far were proven optimal.
  double least_ = kInfinity;  // Smallest value of the relaxation so far.
  double share_ = 1.0;
  int failed_rounds_ = 0;
};

}  // namespace

TeamTours PlanToursByAuction(const OrienteeringProblem& problem,
                             const TeamTourOptions& options) {
  return TourAuction(problem, options).Run();
}

TeamTours PlanToursByPrices(const OrienteeringProblem& problem,
                            const TeamTourOptions& options) {
  return TourPricing(problem, options).Run();
}

}  // namespace kg_selector
