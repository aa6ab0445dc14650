#include "kg_engine/what_if/plan_change.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/units.h"
#include "kg_base/geo/wkt.h"
#include "kg_engine/facts/nav_graph_facts.h"

namespace kg_engine {
namespace {

using kg_compiler::EdgeCost;
using kg_compiler::NavGraph;
using kg_compiler::TraverseEdge;
using kg_selector::Pathlet;
using kg_selector::PlannedMission;
using kg_selector::TeamMember;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaxEdges = 1000;

std::string Wh(double energy_j) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f Wh", energy_j / kg_base::kJoulesPerWh);
  return text;
}

// The present path flown in the hypothetical world.
struct FlownAgain {
  Pathlet path;            // With hypothetical tracks.
  double energy_j = 0.0;   // NaN if it cannot be flown.
  std::string infeasible;  // Reason, or "" if feasible.
};

class Comparison {
 public:
  Comparison(const CompiledPlan& now, const CompiledPlan& then,
             const EdgePrices& prices)
      : now_(now.planned), then_(then.planned), prices_(prices) {}

  std::vector<PathChange> Paths() {
    for (const Pathlet& path : now_.plan.committed) FlyAgain(path);
    std::set<std::string> agents;
    for (const TeamMember& member : now_.members) agents.insert(NameOf(member));
    for (const TeamMember& member : then_.members) {
      agents.insert(NameOf(member));
    }
    std::vector<PathChange> changes;
    for (const std::string& agent : agents) changes.push_back(Change(agent));
    return changes;
  }

  void Edges(WhatIfAnswer* answer) const {
    std::vector<EdgeChange>& changes = answer->changed_edges;
    for (std::size_t i = 0; i < now_.members.size(); ++i) {
      for (std::size_t w = 0; w < now_.members[i].graphs.size(); ++w) {
        CompareGraph(i, w, answer);
      }
    }
    const auto rise = [](const EdgeChange& change) {
      return change.infeasible
                 ? std::numeric_limits<double>::infinity()
                 : change.after.seam_cost - change.before.seam_cost;
    };
    std::stable_sort(
        changes.begin(), changes.end(),
        [&](const auto& a, const auto& b) { return rise(a) > rise(b); });
    if (changes.size() > kMaxEdges) changes.resize(kMaxEdges);
  }

 private:
  void CompareGraph(std::size_t member, std::size_t window,
                    WhatIfAnswer* answer) const {
    const NavGraph& graph = now_.members[member].graphs[window];
    answer->edges += graph.edges.size();
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      const TraverseEdge* then = prices_.Then(member, window, e);
      const double before = graph.edges[e].seam_cost;
      if (then == nullptr) ++answer->edges_infeasible;
      if (then != nullptr && then->seam_cost > before) ++answer->edges_dearer;
      if (then != nullptr && then->seam_cost < before) ++answer->edges_cheaper;
      if (then != nullptr && then->seam_cost == before) continue;
      answer->changed_edges.push_back(Describe(member, window, e, then));
    }
  }

  EdgeChange Describe(std::size_t member, std::size_t window, std::size_t edge,
                      const TraverseEdge* then) const {
    const TeamMember& agent = now_.members[member];
    const NavGraph& graph = agent.graphs[window];
    const kg_base::LonLat from = BeginOf(agent, window, graph.edges[edge]);
    const kg_base::LonLat to = graph.waypoints[graph.edges[edge].to].position;
    EdgeChange change;
    change.agent = NameOf(agent);
    change.window = graph.window;
    change.edge = EdgeNode(graph.hash, graph.edges[edge].from,
                           kg_compiler::StopsOf(graph.edges[edge]))
                      .text;
    change.from = from;
    change.to = to;
    change.infeasible = then == nullptr;
    change.before = kg_compiler::CostOfEdge(graph.edges[edge]);
    change.after = then != nullptr ? kg_compiler::CostOfEdge(*then)
                                   : EdgeCost{kNone, kNone, kNone, kNone, kNone,
                                              kNone, {},    kNone, kNone};
    return change;
  }

  std::size_t PlaceOf(const std::string& agent) const {
    std::size_t place = 0;
    while (NameOf(now_.members[place]) != agent) ++place;
    return place;
  }

  // In order of commitment, so that a conflict is attributed to the later path.
  void FlyAgain(const Pathlet& path) {
    FlownAgain flown = Reprice(path);
    const TeamMember* member = then_.FindMember(path.agent);
    if (member == nullptr) {
      flown.infeasible = "the agent is no longer in the mission";
    } else if (flown.infeasible.empty()) {
      const double budget_j = member->rules.energy_budget_j;
      if (!(flown.energy_j <= budget_j)) {
        flown.infeasible = "it needs " + Wh(flown.energy_j) + ", " +
                           Wh(budget_j) + " are left";
      } else if (const auto conflict = kg_selector::FindConflict(
                     then_.rules, kept_, flown.path)) {
        flown.infeasible = conflict->Line();
      } else {
        kept_.push_back(flown.path);
      }
    }
    again_[path.agent] = std::move(flown);
  }

  FlownAgain Reprice(const Pathlet& path) const {
    FlownAgain flown;
    flown.path = path;
    flown.path.track.clear();
    const std::size_t member = PlaceOf(path.agent);
    for (std::size_t w = 0; w < path.visits.size(); ++w) {
      const kg_selector::Visit& visit = path.visits[w];
      const TraverseEdge* then = prices_.Then(member, w, visit.edge);
      // The first infeasible window decides: the rest cannot be reached.
      if (then == nullptr) {
        flown.energy_j = kNone;
        flown.infeasible = "window " + std::to_string(visit.window) + ": " +
                           kg_base::PointWkt(visit.position) +
                           " cannot be flown to any more";
        return flown;
      }
      flown.energy_j += then->flight.energy_j;
      flown.path.track.insert(flown.path.track.end(),
                              then->flight.track.begin(),
                              then->flight.track.end());
    }
    return flown;
  }

  PathChange Change(const std::string& agent) const {
    PathChange change;
    change.agent = agent;
    Describe(now_, agent, &change.before, &change.agent_iri);
    Describe(then_, agent, &change.after, &change.agent_iri);
    change.changed = !kg_selector::IsSamePath(change.before, change.after);
    const auto again = again_.find(agent);
    if (again != again_.end()) {
      change.energy_needed_j = again->second.energy_j;
      change.infeasible = again->second.infeasible;
    }
    if (const TeamMember* member = then_.FindMember(agent)) {
      change.energy_budget_j = member->rules.energy_budget_j;
    }
    const auto why = then_.plan.unassigned.find(agent);
    if (why != then_.plan.unassigned.end()) change.unassigned = why->second;
    return change;
  }

  static void Describe(const PlannedMission& planned, const std::string& agent,
                       Pathlet* path, std::string* iri) {
    const TeamMember* member = planned.FindMember(agent);
    if (member != nullptr) *iri = member->rules.agent_iri;
    const Pathlet* found = planned.FindPath(agent);
    if (found != nullptr) *path = *found;
  }

  const PlannedMission& now_;
  const PlannedMission& then_;
  const EdgePrices& prices_;
  std::vector<Pathlet> kept_;
  std::map<std::string, FlownAgain> again_;  // By agent.
};

double Energy_j(const kg_selector::CommittedPlan& plan) {
  double sum_j = 0.0;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    sum_j += assignment.pathlet.energy_j;
  }
  return sum_j;
}

}  // namespace

void ComparePlans(const CompiledPlan& now, const CompiledPlan& then,
                  const EdgePrices& prices, WhatIfAnswer* answer) {
  const kg_selector::CommittedPlan before =
      kg_selector::ToCommittedPlan(now.planned);
  answer->plan = kg_selector::ToCommittedPlan(then.planned);
  answer->plan.world_version = then.compilation->world_version;
  answer->dirty = ListRecompiled(*then.compilation);
  answer->reward_change = answer->plan.reward - before.reward;
  answer->energy_change_j = Energy_j(answer->plan) - Energy_j(before);
  Comparison comparison(now, then, prices);
  answer->paths = comparison.Paths();
  comparison.Edges(answer);
}

}  // namespace kg_engine
