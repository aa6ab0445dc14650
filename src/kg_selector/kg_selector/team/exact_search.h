// Mode "exact": columns by the rounds of mode "priced", then the best choice
// among all of them by branch and cut (packing.h), started from the priced
// plan. Pairs that come too close without sharing a row become constraints when
// they are chosen, until none is (lazy constraints).
//
// What it chooses is the best of all that was ever offered (if the time limit
// allows), not of all that could be: the bound says how far from
// that it may be, as in mode "priced". Soft separation is left out of the
// choice and put right by Exchange() after it.

#ifndef KG_SELECTOR_TEAM_EXACT_SEARCH_H_
#define KG_SELECTOR_TEAM_EXACT_SEARCH_H_

#include <set>
#include <vector>

#include "kg_selector/team/priced_search.h"
#include "kg_selector/team/team_search.h"

namespace kg_selector {

struct ExactChoice {
  TeamChoice choice;
  bool optimal = false;  // Among the columns, soft separation aside.
};
// The best choice of a pool; from `start`, which is allowed. Good `prices` of
// rows spare work. Ends after about `time_limit_s`, then with the best so far.
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
