#include "kg_selector/paths/walks.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_compiler/control_plane/window_traversal.h"
#include "kg_planner/tours/micro_paths.h"

namespace kg_selector {
namespace {

using kg_compiler::FlownPath;
using kg_compiler::MovementMode;
using kg_compiler::NavGraph;
using kg_compiler::NavGraphs;
using kg_compiler::SeamRules;
using kg_compiler::TraverseEdge;
using kg_compiler::Waypoint;
using kg_compiler::WindowWorld;

// Minimum share of the best score of its end for a walk to be kept.
constexpr double kGoodEnough = 0.5;
constexpr std::size_t kExactLabels = 4000;
constexpr std::size_t kMaxSteps = 400;
constexpr double kLeastGround_mps = 1e-3;

// The duration of a walk is known only after flying it, so a second pass admits
// walks whose estimate is up to a tenth too long.
struct SearchPass {
  double duration;  // Duration limit as a share of the window.
  int per_end;      // Walks per end, as a multiple of the limit.
};
constexpr SearchPass kSearchPasses[] = {{1.0, 1}, {1.1, 2}};

enum class TravelPace { kPriced, kCruise };

double Length_m(const FlownPath& flight) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < flight.track.size(); ++i) {
    length_m += kg_base::Distance_m(flight.track[i - 1].position,
                                    flight.track[i].position);
  }
  return length_m;
}

// An edge as a leg: time and cost at either pace if flown at the window's
// begin, without station holding.
struct WalkLeg {
  const FlownPath* flight = nullptr;
  double cruise_mps = 0.0;
  double length_m = 0.0;
  double hazard = 0.0;       // Mean along the way.
  double isolation_s = 0.0;  // Per second along the way.
  // Per second along the way, by cost field.
  std::vector<double> exposures = {};
  double turn_rad = 0.0;  // From the start heading.

  double Speed_mps(TravelPace pace) const {
    return pace == TravelPace::kPriced ? flight->speed_mps : cruise_mps;
  }
  // At cruise speed: assumes the same gain from the current per second.
  double Travel_s(TravelPace pace) const {
    const double travel_s = flight->travel_s;
    if (pace == TravelPace::kPriced || !(travel_s > 0.0)) return travel_s;
    const double ground_mps =
        length_m / travel_s + (cruise_mps - flight->speed_mps);
    return length_m / std::max(ground_mps, kLeastGround_mps);
  }
};

class WindowWalks {
 public:
  explicit WindowWalks(const WalkInputs& inputs)
      : in_(inputs),
        weights_(inputs.rules->weights),
        places_(kg_compiler::PositionsOf(inputs.graph->waypoints)),
        traversal_(*inputs.rules, *inputs.window, inputs.world) {
    for (const TraverseEdge& edge : in_.graph->edges) {
      if (edge.via.empty()) entries_[{edge.from, edge.to}] = ToWalkLeg(edge);
    }
    for (const TraverseEdge& edge : in_.graph->inner_edges) {
      inner_[{edge.from, edge.to}] = ToWalkLeg(edge);
    }
  }

  std::vector<TraverseEdge> Find(const WalkOptions& options) const {
    std::vector<TraverseEdge> walks;
    if (inner_.empty()) return walks;
    for (std::size_t from = 0; from < in_.sources.size(); ++from) {
      AddFrom(static_cast<int>(from), options, &walks);
    }
    return walks;
  }

  std::optional<TraverseEdge> Fly(int from,
                                  const std::vector<int>& stops) const {
    std::vector<const FlownPath*> legs;
    double isolation_s = 0.0;
    int at = from;
    for (const int stop : stops) {
      // The first leg leads into the window, the others are within it.
      const auto& edges = legs.empty() ? entries_ : inner_;
      const auto way = edges.find({at, stop});
      if (way == edges.end()) return std::nullopt;
      legs.push_back(way->second.flight);
      isolation_s = way->second.isolation_s;
      at = stop;
    }
    auto walk = traversal_.FlyWalk(in_.sources[from], legs, isolation_s);
    if (!walk) return std::nullopt;
    walk->from = from;
    walk->to = stops.back();
    walk->via.assign(stops.begin(), stops.end() - 1);
    return walk;
  }

 private:
  using Ends = std::pair<int, int>;

  WalkLeg ToWalkLeg(const TraverseEdge& edge) const {
    const FlownPath& flight = edge.flight;
    WalkLeg way;
    way.flight = &flight;
    way.cruise_mps = in_.rules->motion.cruise_mps;
    way.length_m = Length_m(flight);
    const double rest_s =
        in_.window->end_s - in_.window->begin_s - flight.travel_s;
    const double under_way_s =
        flight.hazard_s - rest_s * traversal_.HazardAt(places_[edge.to]);
    if (flight.travel_s > 0.0) {
      way.hazard = std::clamp(under_way_s / flight.travel_s, 0.0, 1.0);
    }
    way.isolation_s = traversal_.Isolation(places_[edge.to], places_);
    way.turn_rad = edge.turn_rad;
    for (const double exposure : edge.exposures) {
      way.exposures.push_back(flight.travel_s > 0.0 ? exposure / flight.travel_s
                                                    : 0.0);
    }
    return way;
  }

  // Both paces only where they differ.
  std::vector<TravelPace> Paces() const {
    if (weights_.energy_per_j > 0.0) {
      return {TravelPace::kPriced, TravelPace::kCruise};
    }
    return {TravelPace::kPriced};
  }

  kg_planner::Leg ToLeg(Ends ends, const WalkLeg& way, TravelPace pace) const {
    const double travel_s = way.Travel_s(pace);
    const double energy_j =
        in_.rules->motion.energy_per_m_j * way.Speed_mps(pace) * travel_s;
    // Confidence 1: the window's uncertainty is not charged per leg.
    TraverseEdge leg;
    leg.turn_rad = way.turn_rad;
    leg.flight.travel_s = travel_s;
    leg.flight.energy_j = energy_j;
    leg.flight.hazard_s = (way.hazard + way.isolation_s) * travel_s;
    for (const double exposure : way.exposures) {
      leg.exposures.push_back(exposure * travel_s);
    }
    return {ends.first, ends.second, SeamCost(weights_, leg, 1.0), energy_j,
            travel_s};
  }

  std::vector<kg_planner::Node> Nodes(bool with_events) const {
    std::vector<kg_planner::Node> nodes;
    for (const Waypoint& waypoint : in_.graph->waypoints) {
      kg_planner::Node& node = nodes.emplace_back();
      node.reward = waypoint.score;
      for (std::size_t e = 0; with_events && e < waypoint.events.size(); ++e) {
        AddToken(waypoint.events[e], &node);
      }
    }
    return nodes;
  }
  void AddToken(const std::string& iri, kg_planner::Node* node) const {
    const auto& events = in_.window->events;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (events[i].iri == iri && events[i].reward > 0.0) {
        node->tokens.push_back({static_cast<int>(i), events[i].reward});
      }
    }
  }

  // Problem from a source at a pace, with all legs timed at the window's begin.
  kg_planner::StageProblem ProblemFrom(int from, TravelPace pace,
                                       bool with_events) const {
    kg_planner::StageProblem problem;
    problem.nodes = Nodes(with_events);
    problem.duration_limit =
        std::min(in_.window->end_s - in_.window->begin_s,
                 in_.window->base_travel_m / in_.rules->motion.cruise_mps);
    for (const auto& [ends, way] : entries_) {
      if (ends.first == from) {
        problem.legs.push_back(ToLeg({-1, ends.second}, way, pace));
      }
    }
    for (const auto& [ends, way] : inner_) {
      problem.legs.push_back(ToLeg(ends, way, pace));
    }
    return problem;
  }

  // Value of a walk or of a direct edge.
  double Worth(const TraverseEdge& edge,
               const std::vector<kg_planner::Node>& nodes) const {
    std::map<int, double> earned;
    double reward = 0.0;
    std::vector<int> visited = edge.via;
    visited.push_back(edge.to);
    for (const int node : visited) {
      reward += nodes[node].reward;
      for (const kg_planner::TokenReward& token : nodes[node].tokens) {
        earned[token.token] = token.reward;
      }
    }
    for (const auto& [token, value] : earned) reward += value;
    return reward - edge.seam_cost;
  }

  bool HasEvents() const {
    return std::any_of(
        in_.graph->waypoints.begin(), in_.graph->waypoints.end(),
        [](const Waypoint& waypoint) { return !waypoint.events.empty(); });
  }

  void AddFrom(int from, const WalkOptions& options,
               std::vector<TraverseEdge>* walks) const {
    std::map<std::vector<int>, std::optional<TraverseEdge>> flown;
    std::set<std::vector<int>> kept;
    for (const bool with_events : {true, false}) {
      if (!with_events && !HasEvents()) continue;
      Fly(from, FindCandidates(from, with_events, options), &flown);
      Choose(from, with_events, options, flown, &kept);
    }
    for (const std::vector<int>& stops : kept) {
      walks->push_back(*flown.at(stops));
    }
    std::sort(walks->end() - static_cast<std::ptrdiff_t>(kept.size()),
              walks->end(), [](const TraverseEdge& a, const TraverseEdge& b) {
                return std::tie(a.to, a.via) < std::tie(b.to, b.via);
              });
  }

  std::set<std::vector<int>> FindCandidates(int from, bool with_events,
                                            const WalkOptions& options) const {
    kg_planner::MicroPathOptions micro;
    micro.good_enough = kGoodEnough;
    micro.max_nodes = options.max_stops;
    micro.exact_labels = kExactLabels;
    micro.max_steps = kMaxSteps;
    std::set<std::vector<int>> candidates;
    // Durations are estimates (legs timed at the window's begin), so slightly
    // too long walks are also tried.
    for (const TravelPace pace : Paces()) {
      kg_planner::StageProblem problem = ProblemFrom(from, pace, with_events);
      const double limit_s = problem.duration_limit;
      for (const SearchPass& pass : kSearchPasses) {
        problem.duration_limit = pass.duration * limit_s;
        micro.per_end = pass.per_end * options.per_end;
        for (const kg_planner::MicroPath& path :
             kg_planner::FindMicroPaths(problem, micro).paths) {
          if (path.nodes.size() > 1) candidates.insert(path.nodes);
        }
      }
    }
    return candidates;
  }

  void Fly(
      int from, const std::set<std::vector<int>>& candidates,
      std::map<std::vector<int>, std::optional<TraverseEdge>>* flown) const {
    for (const std::vector<int>& stops : candidates) {
      if (flown->count(stops) == 0) (*flown)[stops] = Fly(from, stops);
    }
  }

  // Keeps the best walks per end, among those worth more than the direct edge.
  void Choose(
      int from, bool with_events, const WalkOptions& options,
      const std::map<std::vector<int>, std::optional<TraverseEdge>>& flown,
      std::set<std::vector<int>>* kept) const {
    const std::vector<kg_planner::Node> nodes = Nodes(with_events);
    // Reference: value of the direct edge to each end.
    std::map<int, double> direct;
    for (const TraverseEdge& edge : in_.graph->edges) {
      if (edge.from == from && edge.via.empty()) {
        direct[edge.to] = Worth(edge, nodes);
      }
    }
    std::map<int, std::vector<std::pair<double, std::vector<int>>>> by_end;
    for (const auto& [stops, walk] : flown) {
      if (!walk) continue;
      const double worth = Worth(*walk, nodes);
      const auto straight = direct.find(walk->to);
      if (straight != direct.end() && !(worth > straight->second)) continue;
      by_end[walk->to].emplace_back(-worth, stops);
    }
    for (auto& [to, found] : by_end) {
      std::sort(found.begin(), found.end());
      found.resize(
          std::min<std::size_t>(found.size(), std::max(0, options.per_end)));
      for (auto& [worth, stops] : found) kept->insert(std::move(stops));
    }
  }

  const WalkInputs& in_;  // Flights of its graph are referenced.
  const kg_compiler::SeamWeights& weights_;
  std::vector<kg_base::LonLat> places_;
  kg_compiler::WindowTraversal traversal_;
  std::map<Ends, WalkLeg> entries_;
  std::map<Ends, WalkLeg> inner_;
};

NavGraph WithWalks(const WalkInputs& inputs) {
  NavGraph graph = *inputs.graph;
  std::vector<TraverseEdge> walks = FindWalks(inputs, {});
  graph.edges.insert(graph.edges.end(), std::make_move_iterator(walks.begin()),
                     std::make_move_iterator(walks.end()));
  std::sort(graph.edges.begin(), graph.edges.end(),
            [](const TraverseEdge& a, const TraverseEdge& b) {
              return std::tie(a.from, a.to, a.via) <
                     std::tie(b.from, b.to, b.via);
            });
  return graph;
}

NavGraphs::Pointer FindGraph(const NavGraphs& graphs, const std::string& hash) {
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    if (graphs[i].hash == hash) return graphs.Share(i);
  }
  return nullptr;
}

}  // namespace

std::vector<TraverseEdge> FindWalks(const WalkInputs& inputs,
                                    const WalkOptions& options) {
  return WindowWalks(inputs).Find(options);
}

std::optional<TraverseEdge> FlyWalk(const WalkInputs& inputs, int from,
                                    const std::vector<int>& stops) {
  return WindowWalks(inputs).Fly(from, stops);
}

NavGraphs CompileWalkedGraphs(const SeamRules& rules,
                              const std::vector<WindowWorld>& worlds,
                              GraphCache* cache) {
  const NavGraphs plain = kg_compiler::CompileNavGraphs(
      rules, worlds, cache ? &cache->seams : nullptr);
  if (rules.movement_mode == MovementMode::kHops) {
    if (cache) cache->walked.clear();
    return plain;
  }
  NavGraphs walked;
  int searched = 0;
  std::vector<kg_base::LonLat> sources = {rules.start};
  for (std::size_t t = 0; t < plain.size(); ++t) {
    // The hash identifies the graph without walks, which determines the walks.
    const auto known =
        cache ? FindGraph(cache->walked, plain[t].hash) : nullptr;
    if (known) {
      walked.push_back(known);
    } else {
      walked.push_back(WithWalks(
          {&rules, &rules.windows[t], worlds[t], &plain[t], sources}));
      ++searched;
    }
    sources = kg_compiler::PositionsOf(plain[t].waypoints);
  }
  if (cache) {
    cache->walked = walked;
    cache->windows_walked = searched;
  }
  return walked;
}

}  // namespace kg_selector
