// What a team's scarce rows (a place at a window's end, an event) cost: the
// multipliers of its Lagrangian relaxation, and the bound that comes with them.
//
//   L(p) = sum over rows r  p_r capacity_r
//        + sum over agents a  max(0, best score - prices of a)
//
// No plan is worth more than L(p), for any p >= 0: take any plan, let each
// agent pay p_r for each row that it uses. What is paid is at most sum p_r
// capacity_r, and what is left to an agent is at most its best less prices, or
// 0 if it is left out. All that is not a row (tracks that cross within a
// window, soft separation) is left out of the relaxation, which only makes L
// larger.
//
// L is least near good prices. Rows seen to be used too much get dearer, others
// cheaper: the volume algorithm [1], steps of Polyak's length towards the best
// plan known, taken from the best prices known, along the average of past
// choices. It cannot cycle: nothing is decided by comparing with the round
// before, only the best is kept, and the number of rounds is bounded.
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
    std::vector<double> bounds;  // By agent, prices taken off; NaN = unknown.
    std::vector<int> usage;      // By row: agents whose best path uses it.
  };
  // Takes them in. `capacities` by row; new rows cost nothing yet.
  void Learn(const std::vector<int>& capacities, const Answers& answers);

  // The prices to ask for next, given what a plan is known to be worth.
  void Step(double plan);

  // Other prices to ask for next.
  void Set(std::vector<double> prices) { prices_ = std::move(prices); }

  const std::vector<double>& prices() const { return prices_; }
  // Those of the least L so far, and it; infinite if there was none.
  const std::vector<double>& best_prices() const { return best_prices_; }
  double bound() const;
  // The bound has hardly moved for a while.
  bool settled() const;
  // As if there were no such agent.
  void Drop(int agent);

 private:
  void Grow(std::size_t rows);

  std::vector<int> capacities_;
  std::vector<double> prices_;         // Asked for.
  std::vector<double> best_prices_;    // Of the least L.
  std::vector<double> average_usage_;  // Of past answers, by row.
  double rows_part_ =
      std::numeric_limits<double>::infinity();  // Of the least L.
  std::vector<double> agents_part_;
  double step_ = 1.0;
  std::vector<double> bounds_;  // By round, the least until then.
  int failed_steps_ = 0;
};

// What a round at common prices taught.
TeamPrices::Answers SummarizeAnswers(const TeamColumns& pool,
                                     const ColumnAnswers& answers);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_PRICES_H_
