// Mode "exact": columns from the rounds of mode "priced", then the best choice
// among all of them by branch and cut (packing.h), started from the priced
// plan. Pairs that come too close without sharing a row become constraints when
// a solution contains them, until none does (lazy constraints).
//
// The choice is optimal among all paths offered (within the time limit), not
// among all possible paths: the bound limits that gap, as in mode "priced".
// Soft separation is not part of the choice; Exchange() accounts for it
// afterwards.

#ifndef KG_SELECTOR_TEAM_EXACT_SEARCH_H_
#define KG_SELECTOR_TEAM_EXACT_SEARCH_H_

#include <set>
#include <vector>

#include "kg_selector/team/priced_search.h"
#include "kg_selector/team/team_search.h"

namespace kg_selector {

struct ExactChoice {
  TeamChoice choice;
  bool optimal = false;  // Among the columns; ignores soft separation.
};
// The best choice from a pool, started from `start`, which must be allowed.
// Good `prices` of rows reduce the work. Ends after about `time_limit_s` with
// the best choice so far.
ExactChoice ChooseExactly(const TeamColumns& pool, const TeamChoice& start,
                          const std::vector<double>& prices,
                          double time_limit_s);

class ExactSearch : public TeamSearch {
 public:
  explicit ExactSearch(const SearchOptions& options);

  ColumnRequests Next(const TeamColumns& pool,
                      const ColumnAnswers& answers) override;
  void Drop(int agent) override;
  const TeamChoice& choice() const override { return best_; }
  double bound() const override { return priced_.bound(); }
  const std::vector<double>& prices() const override {
    return priced_.prices();
  }

 private:
  SearchOptions options_;
  PricedSearch priced_;
  TeamChoice best_;
  std::set<int> dropped_;
  bool chosen_ = false;
  bool asked_unserved_ = false;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_EXACT_SEARCH_H_
