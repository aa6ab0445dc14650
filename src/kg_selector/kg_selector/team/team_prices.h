// Prices of a team's scarce rows (a place at a window's end, an event): the
// multipliers of its Lagrangian relaxation, and the resulting bound.
//
//   L(p) = sum over rows r  p_r capacity_r
//        + sum over agents a  max(0, best score - prices of a)
//
// No plan is worth more than L(p), for any p >= 0: let each agent of a plan pay
// p_r for each row that it uses. The payments sum to at most sum p_r
// capacity_r, and each agent keeps at most its best score minus prices, or 0 if
// it is left out. Conflicts that are not rows (tracks that cross within a
// window, soft separation) are dropped by the relaxation, which only increases
// L.
//
// L is minimised by the volume algorithm [1]: overused rows become more
// expensive, others cheaper, by Polyak steps towards the best known plan, from
// the best known prices along the average of past choices. It cannot cycle: no
// decision compares with the previous round, only the best is kept, and the
// number of rounds is bounded.
//
// [1] F. Barahona and R. Anbil, "The volume algorithm: producing primal
//     solutions with a subgradient method", Math. Programming 87 (2000)
//     385-399.

#ifndef KG_SELECTOR_TEAM_TEAM_PRICES_H_
#define KG_SELECTOR_TEAM_TEAM_PRICES_H_

#include <limits>
#include <utility>
#include <vector>

#include "kg_selector/team/team_search.h"

namespace kg_selector {

class TeamPrices {
 public:
  // The answers of all agents under prices().
  struct Answers {
    std::vector<double> bounds;  // By agent, score - prices; NaN = unknown.
    // By row: number of agents whose best path uses it.
    std::vector<int> usage;
  };
  // Updates bound and average usage. `capacities` by row; new rows have price
  // 0.
  void Learn(const std::vector<int>& capacities, const Answers& answers);

  // Computes the next prices, given the value of a known plan.
  void Step(double plan);

  // Overrides the next prices.
  void Set(std::vector<double> prices) { prices_ = std::move(prices); }

  const std::vector<double>& prices() const { return prices_; }
  // Prices of the smallest L so far, and that L; infinite if unknown.
  const std::vector<double>& best_prices() const { return best_prices_; }
  double bound() const;
  // True if the bound has hardly moved for kSettledRounds rounds.
  bool settled() const;
  // Removes the agent from the bound.
  void Drop(int agent);

 private:
  void Grow(std::size_t rows);

  std::vector<int> capacities_;
  std::vector<double> prices_;         // Prices of the next request.
  std::vector<double> best_prices_;    // Prices of the smallest L.
  std::vector<double> average_usage_;  // Average of past answers, by row.
  double rows_part_ =
      std::numeric_limits<double>::infinity();  // Row part of the smallest L.
  std::vector<double> agents_part_;
  double step_ = 1.0;
  std::vector<double> bounds_;  // Smallest L up to each round.
  int failed_steps_ = 0;
};

// Bounds and row usage from a round at common prices.
TeamPrices::Answers SummarizeAnswers(const TeamColumns& pool,
                                     const ColumnAnswers& answers);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_PRICES_H_
