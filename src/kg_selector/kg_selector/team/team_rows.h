// What of a mission is scarce, as rows with a capacity: the link between paths
// and the columns of team_columns.h.
//
// Events: as many distinct agents as rules.event_capacity says.
// Places: of agents that hold station at a window's end, only one may be among
// places that all lie closer to each other than the separation. Rows are made
// as places are seen (relax and cut); a new place joins every row it fits into.
// The separation is taken 0.1 % shorter for them, so that two paths of one row
// always conflict.

#ifndef KG_SELECTOR_TEAM_TEAM_ROWS_H_
#define KG_SELECTOR_TEAM_TEAM_ROWS_H_

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/team_plan.h"

namespace kg_selector {

class TeamRows {
 public:
  explicit TeamRows(const TeamRules& rules);

  // Gets to know the places where its windows end.
  void Add(const Pathlet& pathlet);
  // Ascending; of a path that was added. More rows may come with later ones.
  std::vector<int> UsedRows(const Pathlet& pathlet) const;
  const std::vector<int>& capacities() const { return capacities_; }

  // What `agent` has to pay for rows, in words of its own.
  void PutPrices(const std::string& agent, const std::vector<double>& prices,
                 PlanRequest* request) const;

 private:
  struct Place {
    kg_base::LonLat position;
    std::vector<int> rows;
    // Who has it as which waypoint.
    std::set<std::pair<std::string, int>> waypoints;
  };
  struct Clique {
    int window = 0;
    std::vector<int> places;  // Index in the window's.
  };
  // The place where a visit holds station; nothing if it is elsewhere then.
  bool HoldsStation(const Pathlet& pathlet, const Visit& visit) const;
  int AddPlace(int window, kg_base::LonLat position);
  void JoinCliques(int window, int place);
  void AddMissingRows(int window, int place);
  bool AreClose(int window, int a, int b) const;
  bool FitsInto(int place, const Clique& clique) const;
  void AddToClique(int row, int place);

  const TeamRules& rules_;
  double separation_m_ = 0.0;
  std::vector<int> capacities_;
  std::map<std::string, int> events_;         // Row by event.
  std::map<int, Clique> cliques_;             // By row.
  std::map<int, std::vector<Place>> places_;  // By window.
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_ROWS_H_
