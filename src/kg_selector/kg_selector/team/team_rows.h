// Scarce resources of a mission as rows with a capacity: the link between paths
// and the columns of team_columns.h.
//
// Events: capacity rules.event_capacity. Places: of agents that hold station at
// a window's end, at most one may be in a set of places that are pairwise
// closer than the separation. Rows are added as places appear (relax and cut);
// a new place joins every row it fits into. The separation is shortened by 0.1
// % for this test, so that two paths of one row always conflict.

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

  // Registers the places where the path's windows end.
  void Add(const Pathlet& pathlet);
  // Rows of a registered path, ascending. Rows added later may extend them.
  std::vector<int> UsedRows(const Pathlet& pathlet) const;
  const std::vector<int>& capacities() const { return capacities_; }

  // Writes row prices as event and waypoint prices of `agent` (its own waypoint
  // ids).
  void PutPrices(const std::string& agent, const std::vector<double>& prices,
                 PlanRequest* request) const;

 private:
  struct Place {
    kg_base::LonLat position;
    std::vector<int> rows;
    // (agent, waypoint id in its graph) pairs of the place.
    std::set<std::pair<std::string, int>> waypoints;
  };
  struct Clique {
    int window = 0;
    std::vector<int> places;  // Indices into the window's places.
  };
  // True if the path is at the visit's place when the window ends.
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
  std::map<int, Clique> cliques_;             // Clique by row.
  std::map<int, std::vector<Place>> places_;  // Places by window.
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_ROWS_H_
