// Enumerates every path of a member of a small team by traversing its graphs:
// the reference for tests of planners and teams. Shares no code with trellises
// and prices.

#ifndef KG_SELECTOR_TESTING_EVERY_PATH_H_
#define KG_SELECTOR_TESTING_EVERY_PATH_H_

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kg_selector/team/plan_team.h"

namespace kg_selector {

struct EveryPath {
  std::vector<int> nodes;
  double score = 0.0;  // Score without events.
  double energy_j = 0.0;
  std::map<std::string, double> events;  // Largest reward of each event met.
  std::vector<kg_compiler::TimedPoint> track;
};

inline void ExtendPath(const TeamMember& member, const EveryPath& path,
                       std::vector<EveryPath>* all) {
  const std::size_t stage = path.nodes.size();
  if (stage == member.graphs.size()) {
    if (path.energy_j <= member.rules.energy_budget_j) all->push_back(path);
    return;
  }
  for (const auto& edge : member.graphs[stage].edges) {
    if (edge.from != (stage == 0 ? 0 : path.nodes.back())) continue;
    const auto& waypoint = member.graphs[stage].waypoints[edge.to];
    // Events are met, not earned: capacity decides which ones count.
    EveryPath longer = path;
    longer.nodes.push_back(edge.to);
    longer.score += waypoint.score - edge.seam_cost;
    longer.energy_j += edge.flight.energy_j;
    longer.track.insert(longer.track.end(), edge.flight.track.begin(),
                        edge.flight.track.end());
    for (const auto& rule : member.rules.windows[stage].events) {
      if (std::count(waypoint.events.begin(), waypoint.events.end(),
                     rule.iri)) {
        longer.events[rule.iri] =
            std::max(longer.events[rule.iri], rule.reward);
      }
    }
    ExtendPath(member, longer, all);
  }
}

inline std::vector<EveryPath> EnumeratePaths(const TeamMember& member) {
  std::vector<EveryPath> all;
  ExtendPath(member, {}, &all);
  return all;
}

}  // namespace kg_selector

#endif  // KG_SELECTOR_TESTING_EVERY_PATH_H_
