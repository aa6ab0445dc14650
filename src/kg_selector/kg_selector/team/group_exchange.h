// Small groups of agents release their columns and replan one after the other
// around all other agents: escapes plans that no single agent can improve.
// Large neighbourhood search [1] whose moves are requests to planners.
//
// All groups of a wave run in parallel, so a wave takes as many rounds as a
// group has members. The first members pay a random share of the prices, the
// last pays none: it takes the best column that is left. A group's new columns
// replace its old ones if the plan stays within `slack` of the best known plan;
// `slack` shrinks to 0 (record-to-record travel [2]); the best plan is kept.
//
// A group is a random agent and the agents that hold rows of its best column
// under the prices. Seeded: the same answers give the same plan.
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
  // Starts a wave from `choice`; returns the first requests. Empty = no agents.
  ColumnRequests Begin(const TeamColumns& pool, const TeamChoice& choice,
                       const std::vector<double>& prices);
  // Takes the answers, returns the next requests. Empty = the wave is over.
  ColumnRequests Next(const ColumnAnswers& answers);
  // Final choice of the wave: at most `slack` below `best`.
  TeamChoice End(const TeamColumns& pool, const TeamWorth& best,
                 double slack) const;
  void Drop(int agent);

 private:
  struct Group {
    std::vector<int> members;  // Agents in planning order.
    std::vector<int> columns;  // New columns of the members that answered.
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
  std::size_t member_ = 0;  // Index of the member being asked, per group.
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_GROUP_EXCHANGE_H_
