#include "kg_selector/paths/masking.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "kg_selector/paths/churn.h"
#include "kg_selector/paths/path_rules.h"

namespace kg_selector {
namespace {

using kg_compiler::EventRule;
using kg_compiler::NavGraph;
using kg_compiler::NavGraphs;
using kg_compiler::SeamRules;
using kg_compiler::TimedPoint;
using kg_compiler::TraverseEdge;
using kg_compiler::Waypoint;

constexpr double kNever = -std::numeric_limits<double>::infinity();

// Rewards of the events open in a window.
std::map<std::string, double> OpenEvents(const SeamRules& rules, int window) {
  std::map<std::string, double> rewards;
  for (const auto& rule : rules.windows) {
    if (rule.window == window) {
      for (const EventRule& event : rule.events) {
        if (event.reward > 0.0) rewards[event.iri] = event.reward;
      }
    }
  }
  return rewards;
}

// Token number of every event of any window.
std::map<std::string, int> NumberEvents(const SeamRules& rules) {
  std::map<std::string, int> tokens;
  for (const auto& window : rules.windows) {
    for (const EventRule& event : window.events) tokens.emplace(event.iri, 0);
  }
  int next = 0;
  for (auto& [event, token] : tokens) token = next++;
  return tokens;
}

bool HasWalks(const NavGraph& graph) {
  return std::any_of(
      graph.edges.begin(), graph.edges.end(),
      [](const TraverseEdge& edge) { return !edge.via.empty(); });
}

kg_planner::Node ToNode(const Waypoint& waypoint,
                        const std::map<std::string, double>& open,
                        const std::map<std::string, int>& tokens) {
  kg_planner::Node node;
  node.reward = waypoint.score;
  for (const std::string& event : waypoint.events) {
    const auto reward = open.find(event);
    if (reward != open.end()) {
      node.tokens.push_back({tokens.at(event), reward->second});
    }
  }
  return node;
}

double WindowEnd(const NavGraph& graph) {
  double end_s = kNever;
  for (const TraverseEdge& edge : graph.edges) {
    if (!edge.flight.track.empty()) {
      end_s = std::max(end_s, edge.flight.track.back().time_s);
    }
  }
  return end_s;
}

std::vector<double> WindowEnds(const NavGraphs& graphs) {
  std::vector<double> ends_s;
  for (const NavGraph& graph : graphs) ends_s.push_back(WindowEnd(graph));
  return ends_s;
}

// Track of a seam: waiting from the end of the previous window if there is a
// gap, then the flight. A path's track is their concatenation.
std::vector<TimedPoint> SeamTrack(const NavGraphs& graphs,
                                  const std::vector<double>& ends_s,
                                  std::size_t stage, const TraverseEdge& edge) {
  std::vector<TimedPoint> track = edge.flight.track;
  if (stage == 0 || track.empty()) return track;
  const double before_s = ends_s[stage - 1];
  if (before_s > kNever && before_s < track.front().time_s) {
    track.insert(
        track.begin(),
        {graphs[stage - 1].waypoints.at(edge.from).position, before_s});
  }
  return track;
}

// The edge a path takes into a stage: seams are the graph's edges, in their
// order.
const TraverseEdge& TakenEdge(const NavGraphs& graphs,
                              const kg_planner::Path& path, std::size_t stage) {
  return graphs[stage].edges.at(path.seams.at(stage));
}

std::vector<const Waypoint*> VisitedBy(const NavGraph& graph,
                                       const TraverseEdge& edge) {
  std::vector<const Waypoint*> visited;
  for (const int id : edge.via) visited.push_back(&graph.waypoints.at(id));
  visited.push_back(&graph.waypoints.at(edge.to));
  return visited;
}

// Stage that earns each open event on the path, by event.
std::map<std::string, std::size_t> EarnedWhere(const SeamRules& rules,
                                               const NavGraphs& graphs,
                                               const kg_planner::Path& path) {
  std::map<std::string, std::size_t> where;
  std::map<std::string, double> best;
  for (std::size_t s = 0; s < path.nodes.size(); ++s) {
    const auto open = OpenEvents(rules, graphs[s].window);
    for (const Waypoint* place :
         VisitedBy(graphs[s], TakenEdge(graphs, path, s))) {
      for (const std::string& event : place->events) {
        const auto reward = open.find(event);
        if (reward == open.end() || !(reward->second > best[event])) continue;
        best[event] = reward->second;
        where[event] = s;
      }
    }
  }
  return where;
}

Visit ToVisit(const NavGraph& graph, const TraverseEdge& edge) {
  const Waypoint& end = graph.waypoints.at(edge.to);
  Visit visit{graph.window, edge.to, end.position, 0.0, {}, {}};
  for (const Waypoint* place : VisitedBy(graph, edge)) {
    visit.reward += place->score;
  }
  for (const int id : edge.via) {
    visit.via.push_back({id, graph.waypoints.at(id).position});
  }
  visit.cost = kg_compiler::CostOfEdge(edge);
  visit.edge = static_cast<int>(&edge - graph.edges.data());
  return visit;
}

}  // namespace

SeamRules CloseEvents(SeamRules rules, const std::set<std::string>& full) {
  for (auto& window : rules.windows) {
    auto& events = window.events;
    events.erase(std::remove_if(events.begin(), events.end(),
                                [&](const EventRule& event) {
                                  return full.count(event.iri) > 0;
                                }),
                 events.end());
  }
  return rules;
}

kg_planner::Trellis ToTrellis(const SeamRules& rules, const NavGraphs& graphs) {
  const std::map<std::string, int> tokens = NumberEvents(rules);
  kg_planner::Trellis trellis;
  trellis.resource_limit = rules.energy_budget_j;
  for (const NavGraph& graph : graphs) {
    const auto open = OpenEvents(rules, graph.window);
    kg_planner::Stage& stage = trellis.stages.emplace_back();
    for (const Waypoint& waypoint : graph.waypoints) {
      stage.nodes.push_back(ToNode(waypoint, open, tokens));
    }
    for (const TraverseEdge& edge : graph.edges) {
      stage.seams.push_back(
          {edge.from, edge.to, edge.seam_cost, edge.flight.energy_j});
    }
    // `via` stays empty if no edge has stops, which speeds up the search.
    if (!HasWalks(graph)) continue;
    for (const TraverseEdge& edge : graph.edges) stage.via.push_back(edge.via);
  }
  AddChurn(rules, graphs, &trellis);
  LimitHazard(rules, graphs, &trellis);
  return trellis;
}

kg_planner::PathMasks MaskCommitted(const TeamRules& rules,
                                    const NavGraphs& graphs,
                                    const std::vector<Pathlet>& committed) {
  kg_planner::PathMasks masks;
  const std::vector<double> ends_s = WindowEnds(graphs);
  const double separation_m = HardSeparation_m(rules);
  for (std::size_t s = 0; s < graphs.size(); ++s) {
    for (const TraverseEdge& edge : graphs[s].edges) {
      const auto track = SeamTrack(graphs, ends_s, s, edge);
      const auto too_close = [&](const Pathlet& other) {
        // Agents may start closer than the separation.
        TimeSpan span;
        if (s == 0) {
          span.from_s =
              SeparationBegins_s(rules, graphs[s].window, track, other.track);
        }
        return ComeCloserThan(track, other.track, separation_m, span);
      };
      if (std::any_of(committed.begin(), committed.end(), too_close)) {
        masks.seams.push_back(
            {static_cast<int>(s), edge.from, edge.to, edge.via});
      }
    }
  }
  return masks;
}

Pathlet ToPathlet(const SeamRules& rules, const NavGraphs& graphs,
                  const kg_planner::Path& path, int rank) {
  Pathlet pathlet;
  pathlet.agent = rules.agent_iri;
  pathlet.rank = rank;
  pathlet.reward = path.reward;
  pathlet.seam_cost = path.cost;
  pathlet.energy_j = path.resource;
  const std::vector<double> ends_s = WindowEnds(graphs);
  for (std::size_t s = 0; s < path.nodes.size(); ++s) {
    const TraverseEdge& edge = TakenEdge(graphs, path, s);
    pathlet.visits.push_back(ToVisit(graphs[s], edge));
    const auto track = SeamTrack(graphs, ends_s, s, edge);
    pathlet.track.insert(pathlet.track.end(), track.begin(), track.end());
  }
  // List each event once, in the window with its largest reward.
  for (const auto& [event, s] : EarnedWhere(rules, graphs, path)) {
    pathlet.visits[s].events.push_back(event);
    pathlet.visits[s].reward += OpenEvents(rules, graphs[s].window).at(event);
  }
  return pathlet;
}

}  // namespace kg_selector
