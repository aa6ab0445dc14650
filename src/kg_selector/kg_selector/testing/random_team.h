// Small random teams with flights between shared places, for the tests of this
// package.

#ifndef KG_SELECTOR_TESTING_RANDOM_TEAM_H_
#define KG_SELECTOR_TESTING_RANDOM_TEAM_H_

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "kg_base/geo/geodesy.h"
#include "kg_selector/team/plan_team.h"

namespace kg_selector {

struct RandomTeamOptions {
  int agents = 3;
  int windows = 3;
  int places = 6;  // Places shared by all agents, in a square of about 25 km.
  int waypoints = 4;  // Per window.
  int events = 2;
  bool same_start = false;
  double begin_s = 1.5e9;
  double window_s = 6 * 3600.0;
  double gap_s = 0.0;  // Gap between windows [s].
  bool walks = false;  // Also edges via another waypoint.
};

class RandomTeam {
 public:
  RandomTeam(const RandomTeamOptions& options, unsigned seed)
      : options_(options), prng_(seed) {
    for (int i = 0; i < options.places; ++i) places_.push_back(AnyPlace());
  }

  TeamRules MakeRules() {
    TeamRules rules;
    rules.max_rounds = 100;
    rules.separation_m = Whole(0, 1) == 0 ? 0.0 : Number(500.0, kLeastApart_m);
    for (int i = 0; i < options_.events; ++i) {
      rules.event_capacity[Event(i)] = Whole(0, 2);
    }
    return rules;
  }

  std::vector<TeamMember> MakeMembers() {
    std::vector<TeamMember> members;
    std::vector<kg_base::LonLat> starts(options_.agents, AnyPlace());
    for (int i = 1; i < options_.agents && !options_.same_start; ++i) {
      const auto taken = starts.begin() + i;
      do {
        *taken = AnyPlace();
      } while (std::any_of(starts.begin(), taken, [&](kg_base::LonLat other) {
        return kg_base::Distance_m(*taken, other) < kLeastApart_m;
      }));
    }
    for (int i = 0; i < options_.agents; ++i) {
      members.push_back(MakeMember(i, starts[i]));
    }
    return members;
  }

  double Number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(prng_);
  }
  int Whole(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(prng_);
  }
  std::mt19937& prng() { return prng_; }

 private:
  // Minimum distance of starts [m]; separations do not exceed it.
  static constexpr double kLeastApart_m = 6000.0;

  static std::string Event(int i) { return "ex:event" + std::to_string(i); }

  kg_base::LonLat AnyPlace() {
    return {Number(-90.0, -89.75), Number(25.0, 25.23)};
  }

  TeamMember MakeMember(int number, kg_base::LonLat start) {
    TeamMember member;
    member.rules.agent_iri = "ex:agent" + std::to_string(number);
    member.rules.candidates = 5;
    member.rules.start = start;
    member.rules.energy_budget_j = Whole(0, 1) == 0 ? 1e9 : 6000.0;
    for (int w = 0; w < options_.windows; ++w) {
      member.rules.windows.push_back(MakeWindow(w));
      member.graphs.push_back(MakeGraph(member, w));
    }
    return member;
  }

  kg_compiler::WindowRules MakeWindow(int w) {
    kg_compiler::WindowRules window;
    window.window = w;
    window.begin_s = options_.begin_s + w * options_.window_s;
    window.end_s = window.begin_s + options_.window_s - options_.gap_s;
    for (int i = 0; i < options_.events; ++i) {
      window.events.push_back({Event(i), places_[i], Number(1.0, 8.0), 1000.0});
    }
    return window;
  }

  kg_compiler::NavGraph MakeGraph(const TeamMember& member, int w) {
    kg_compiler::NavGraph graph;
    graph.agent_iri = member.rules.agent_iri;
    graph.window = w;
    // Each window has another sample of the shared places.
    std::vector<int> places(places_.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] = static_cast<int>(i);
    }
    std::shuffle(places.begin(), places.end(), prng_);
    for (int i = 0; i < options_.waypoints; ++i) {
      kg_compiler::Waypoint waypoint;
      waypoint.id = i;
      waypoint.position = places_[places[i]];
      waypoint.score = Number(0.0, 10.0);
      if (places[i] < options_.events) {
        waypoint.events.push_back(Event(places[i]));
      }
      graph.waypoints.push_back(waypoint);
    }
    AddEdges(member, w, &graph);
    return graph;
  }

  void AddEdges(const TeamMember& member, int w, kg_compiler::NavGraph* graph) {
    const auto& before =
        w == 0 ? graph->waypoints : member.graphs[w - 1].waypoints;
    const int from_count = w == 0 ? 1 : static_cast<int>(before.size());
    for (int u = 0; u < from_count; ++u) {
      for (const kg_compiler::Waypoint& to : graph->waypoints) {
        const kg_base::LonLat from =
            w == 0 ? member.rules.start : before[u].position;
        if (Whole(0, 9) > 0) {
          graph->edges.push_back(
              MakeEdge(u, to, from, member.rules.windows[w]));
        }
        if (options_.walks) AddWalk(graph->edges, to, graph);
      }
    }
  }

  // Adds an edge like the last one to `to`, via a waypoint at its bend.
  void AddWalk(const std::vector<kg_compiler::TraverseEdge>& edges,
               const kg_compiler::Waypoint& to, kg_compiler::NavGraph* graph) {
    const int count = static_cast<int>(graph->waypoints.size());
    const int stop = Whole(0, count - 1);
    if (edges.empty() || edges.back().to != to.id || stop == to.id ||
        !edges.back().via.empty() || !(edges.back().flight.travel_s > 0.0)) {
      return;
    }
    kg_compiler::TraverseEdge walk = edges.back();
    walk.via = {stop};
    walk.flight.track[1].position = graph->waypoints[stop].position;
    walk.flight.energy_j *= Number(1.0, 1.5);
    walk.seam_cost *= Number(1.0, 2.0);
    graph->edges.push_back(walk);
  }

  // A flight with a bend half way, at 2.5 to 4 m/s, then holding station: no
  // distance takes longer than the shortest window.
  kg_compiler::TraverseEdge MakeEdge(int u, const kg_compiler::Waypoint& to,
                                     kg_base::LonLat from,
                                     const kg_compiler::WindowRules& window) {
    kg_compiler::TraverseEdge edge;
    edge.from = u;
    edge.to = to.id;
    const double distance_m = kg_base::Distance_m(from, to.position);
    edge.flight.travel_s = distance_m / Number(2.5, 4.0);
    edge.flight.energy_j = distance_m * Number(0.05, 0.2);
    edge.seam_cost = distance_m * 1e-4;
    const double bend_deg = distance_m > 0.0 ? 0.02 : 0.0;
    const kg_base::LonLat bend = {
        0.5 * (from.lon_deg + to.position.lon_deg) + bend_deg * Number(-1, 1),
        0.5 * (from.lat_deg + to.position.lat_deg) + bend_deg * Number(-1, 1)};
    edge.flight.track = {{from, window.begin_s},
                         {bend, window.begin_s + 0.5 * edge.flight.travel_s},
                         {to.position, window.begin_s + edge.flight.travel_s},
                         {to.position, window.end_s}};
    return edge;
  }

  RandomTeamOptions options_;
  std::mt19937 prng_;
  std::vector<kg_base::LonLat> places_;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TESTING_RANDOM_TEAM_H_
