// Small groups of agents give up their columns and plan again, one after the
// other, beside all other agents: escapes plans that no single agent can
// improve. Large neighbourhood search [1] whose moves are requests to planners.
//
// All groups of one wave work at the same time, so a wave takes as many rounds
// as a group has members. The first members pay a random share of the prices,
// the last none: it takes the best that is left. A group's new columns replace
// its old ones if the plan stays within `slack` of the best known, which
// shrinks to 0 (record-to-record travel [2]); the best is kept.
//
// A group is one agent, chosen at random, and those that hold the rows of its
// best column under the prices. Chance is seeded: the same answers, the same
// plan.
//
// [1] P. Shaw, "Using Constraint Programming and Local Search Methods to Solve
//     Vehicle Routing Problems", CP 1998, LNCS 1520, 417-431.
// [2] G. Dueck, "New Optimization Heuristics: The Great Deluge Algorithm
//     and the Record-to-Record Travel", J. Comput. Phys. 104 (1993) 86-92.

#ifndef KG_SELECTOR_TEAM_GROUP_EXCHANGE_H_
#define KG_SELECTOR_TEAM_GROUP_EXCHANGE_H_

#include <cstddef>
#include <random>
#include <set>
#include <vector>

#include "kg_selector/team/team_search.h"

namespace kg_selector {

class GroupExchange {
 public:
  // Starts a wave from `choice`; the first questions. None if there are no
  // agents.
  ColumnRequests Begin(const TeamColumns& pool, const TeamChoice& choice,
                       const std::vector<double>& prices);
  // Takes the answers; the next questions. None = the wave is over.
  ColumnRequests Next(const ColumnAnswers& answers);
  // What the wave ends with: at most `slack` below `best`.
  TeamChoice End(const TeamColumns& pool, const TeamWorth& best,
                 double slack) const;
  void Drop(int agent);

 private:
  struct Group {
    std::vector<int> members;  // In order of planning.
    std::vector<int> columns;  // New, of the members that have answered.
    double share =
        0.0;  // Share of the prices that all but the last member pay.
  };
  void MakeGroups(const TeamColumns& pool);
  std::vector<int> FindRivals(const TeamColumns& pool, int agent,
                              const std::set<int>& free);
  ColumnRequests RequestMembers() const;
  int Random(int count) { return static_cast<int>(prng_() % count); }

  std::mt19937 prng_;  // Default seed.
  TeamChoice choice_;
  std::vector<double> prices_;
  std::vector<Group> groups_;
  std::set<int> dropped_;
  std::size_t member_ = 0;  // Being asked, of every group.
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_GROUP_EXCHANGE_H_
