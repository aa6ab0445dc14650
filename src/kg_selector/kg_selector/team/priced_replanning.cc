#include "kg_selector/team/priced_replanning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/paths/path_rules.h"

namespace kg_selector {
namespace {

using kg_compiler::NavGraphs;
using kg_compiler::SeamRules;
using kg_planner::Trellis;

double FindPrice(const std::map<std::string, double>& prices,
                 const std::string& event) {
  const auto price = prices.find(event);
  return price == prices.end() ? 0.0 : price->second;
}

void CheckPrice(const std::string& of, double price) {
  if (std::isfinite(price) && price >= 0.0) return;
  throw kg_base::InputError("price of " + of + " is " + std::to_string(price) +
                            ": expected a finite number >= 0");
}

std::size_t FindPricedStage(const NavGraphs& graphs,
                            const WaypointPrice& price) {
  const std::string name = "waypoint " + std::to_string(price.waypoint) +
                           " of window " + std::to_string(price.window);
  CheckPrice(name, price.price);
  for (std::size_t s = 0; s < graphs.size(); ++s) {
    if (graphs[s].window != price.window) continue;
    const int count = static_cast<int>(graphs[s].waypoints.size());
    if (price.waypoint >= 0 && price.waypoint < count) return s;
  }
  throw kg_base::InputError("price of " + name + ": there is none");
}

bool HasPrices(const PlanRequest& request) {
  return !request.waypoint_prices.empty() || !request.event_prices.empty();
}

// Seam of a path into a stage: the one it names, else the one between its
// nodes.
std::size_t TakenSeam(const Trellis& trellis, const kg_planner::Path& path,
                      std::size_t s) {
  if (!path.seams.empty()) return path.seams[s];
  const int from = s == 0 ? 0 : path.nodes[s - 1];
  const auto& seams = trellis.stages[s].seams;
  const auto taken =
      std::find_if(seams.begin(), seams.end(), [&](const auto& seam) {
        return seam.from == from && seam.to == path.nodes[s];
      });
  return taken - seams.begin();
}

// Stops on the way, then the node.
std::vector<int> VisitedNodes(const kg_planner::Stage& stage,
                              std::size_t seam) {
  std::vector<int> nodes;
  if (!stage.via.empty()) nodes = stage.via[seam];
  nodes.push_back(stage.seams[seam].to);
  return nodes;
}

}  // namespace

const std::string& NameOf(const TeamMember& member) {
  return member.rules.agent_id.empty() ? member.rules.agent_iri
                                       : member.rules.agent_id;
}

const char* NoPathNote(const bool alone) {
  return alone ? "no path leads through all windows"
               : "no path is left beside the others'";
}

SeamRules OpenRules(const SeamRules& rules, const PlanRequest& request) {
  for (const auto& [event, price] : request.event_prices) {
    CheckPrice(event, price);
  }
  SeamRules open = CloseEvents(rules, request.full_events);
  for (auto& window : open.windows) {
    auto& events = window.events;
    events.erase(std::remove_if(events.begin(), events.end(),
                                [&](const kg_compiler::EventRule& event) {
                                  const double price = FindPrice(
                                      request.event_prices, event.iri);
                                  return price > 0.0 && !(event.reward > price);
                                }),
                 events.end());
  }
  return open;
}

Trellis PricedTrellis(const SeamRules& open, const NavGraphs& graphs,
                      const PlanRequest& request) {
  SeamRules priced = open;
  for (auto& window : priced.windows) {
    for (kg_compiler::EventRule& event : window.events) {
      event.reward -= FindPrice(request.event_prices, event.iri);
    }
  }
  Trellis trellis = ToTrellis(priced, graphs);
  // Prices of one waypoint add up. They are paid on the seam that ends there,
  // so that stops on the way are free.
  std::vector<std::map<int, double>> paid(graphs.size());
  for (const WaypointPrice& price : request.waypoint_prices) {
    paid[FindPricedStage(graphs, price)][price.waypoint] += price.price;
  }
  for (std::size_t s = 0; s < graphs.size(); ++s) {
    for (kg_planner::Seam& seam : trellis.stages[s].seams) {
      const auto price = paid[s].find(seam.to);
      if (price != paid[s].end()) seam.cost += price->second;
    }
  }
  return trellis;
}

kg_planner::Path Unpriced(const Trellis& unpriced, kg_planner::Path path) {
  std::map<int, double> tokens;
  path.reward = 0.0;
  path.cost = 0.0;
  for (std::size_t s = 0; s < path.nodes.size(); ++s) {
    const kg_planner::Stage& stage = unpriced.stages[s];
    const std::size_t seam = TakenSeam(unpriced, path, s);
    for (const int node : VisitedNodes(stage, seam)) {
      path.reward += stage.nodes[node].reward;
      for (const auto& token : stage.nodes[node].tokens) {
        tokens[token.token] = std::max(tokens[token.token], token.reward);
      }
    }
    path.cost += stage.seams[seam].cost;
  }
  for (const auto& [token, reward] : tokens) path.reward += reward;
  return path;
}

AgentOffer PlanPriced(const TeamRules& team, const TeamMember& member,
                      const PlanRequest& request) {
  const SeamRules& rules = member.rules;
  const NavGraphs& graphs = member.graphs;
  if (graphs.empty()) return {};
  const SeamRules open = OpenRules(rules, request);
  const Trellis unpriced = ToTrellis(open, graphs);
  const bool priced = HasPrices(request);
  const kg_planner::KBest best = ChoosePaths(
      rules, priced ? PricedTrellis(open, graphs, request) : unpriced,
      MaskCommitted(team, graphs, request.around), member.memory.get());
  AgentOffer candidates;
  candidates.proven = best.proven;
  // The bound includes prices, the pathlets do not.
  candidates.bound = best.bound;
  for (const kg_planner::Path& path : best.paths) {
    candidates.pathlets.push_back(
        ToPathlet(open, graphs, priced ? Unpriced(unpriced, path) : path,
                  static_cast<int>(candidates.pathlets.size())));
  }
  for (Pathlet& pathlet : candidates.pathlets) pathlet.agent = NameOf(member);
  if (best.paths.empty()) candidates.note = BudgetNote(rules, best);
  if (best.paths.empty() && candidates.note.empty()) {
    candidates.note = NoPathNote(request.around.empty());
  }
  return candidates;
}

}  // namespace kg_selector
