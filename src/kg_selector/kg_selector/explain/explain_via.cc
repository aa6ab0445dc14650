#include "kg_selector/explain/explain_via.h"

#include <limits>
#include <optional>
#include <utility>

#include "kg_base/common/units.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_selector/explain/path_terms.h"
#include "kg_selector/paths/masking.h"

namespace kg_selector {
namespace {

using kg_compiler::Explanation;
using kg_compiler::operator+;
using kg_compiler::Short;
using kg_core::AbbreviateIri;

class ViaExplainer {
 public:
  ViaExplainer(const PlannedWorld& world, const kg_mission::Agent& agent,
               const ViaWaypoints& by)
      : world_(world),
        agent_(agent),
        member_(FindMember(world, agent)),
        by_(by),
        before_(CommittedBefore(world, agent.iri)),
        facts_(world.facts()) {
    for (const auto& edge : member_.graphs[by.stage].edges) {
      if (!IsByWay(edge)) {
        masks_.seams.push_back(
            {static_cast<int>(by.stage), edge.from, edge.to, edge.via});
      }
    }
  }

  Explanation Explain() {
    const FoundPath best = FindBest(world_, member_, {masks_, nullptr});
    if (best.pathlet) return WorthLess(best);
    if (const auto path = Relaxed({false, true})) return Conflict(*path);
    if (const auto path = Relaxed({true, false})) return Energy(*path);
    if (const auto path = Relaxed({false, false})) return Conflict(*path);
    return DeadEnd();
  }

 private:
  struct Kept {
    bool distance = true;  // Keep distance to committed paths.
    bool energy = true;    // False: find the path of least energy.
  };

  bool IsByWay(const kg_compiler::TraverseEdge& edge) const {
    for (const int stop : kg_compiler::StopsOf(edge)) {
      if (by_.waypoints.count(stop) > 0) return true;
    }
    return false;
  }

  std::optional<Pathlet> Relaxed(const Kept& kept) const {
    const kg_compiler::SeamRules open =
        CloseEvents(member_.rules, FullEvents(world_.rules, before_));
    kg_planner::Trellis trellis = ToTrellis(open, member_.graphs);
    if (!kept.energy) CountEnergyOnly(&trellis);
    kg_planner::PathMasks masks = masks_;
    if (kept.distance) {
      const auto close = MaskCommitted(world_.rules, member_.graphs, before_);
      masks.seams.insert(masks.seams.end(), close.seams.begin(),
                         close.seams.end());
    }
    const auto best = kg_planner::FindKBest(trellis, masks, {1, 100000});
    if (best.paths.empty()) return std::nullopt;
    return ToPathlet(open, member_.graphs, best.paths.front(), 0);
  }

  static void CountEnergyOnly(kg_planner::Trellis* trellis) {
    trellis->resource_limit = std::numeric_limits<double>::infinity();
    for (auto& stage : trellis->stages) {
      for (auto& node : stage.nodes) node = {};
      for (auto& seam : stage.seams) seam.cost = seam.resource;
    }
  }

  Explanation Named(const char* verdict, const char* unit,
                    const std::string& why) const {
    Explanation explanation;
    explanation.verdict = verdict;
    explanation.unit = unit;
    explanation.text = agent_.id + " does not go to " + by_.name + ": " + why;
    return explanation;
  }

  Explanation WorthLess(const FoundPath& best) const {
    const Pathlet& chosen = *FindPath(world_, agent_.iri);
    Explanation margin = Difference(world_, member_, chosen, *best.pathlet);
    Explanation explanation = Named(
        "worth_less", "reward",
        "the best path by way of it scores " + Short(best.pathlet->score()) +
            ", the path chosen " + Short(chosen.score()) + ", " +
            Short(margin.value) + " more.");
    if (margin.value < -1e-9) {
      explanation.text +=
          " It was not among the paths that the choice was made from.";
    }
    if (!best.proven) explanation.text += " The search for it was cut short.";
    explanation.value = margin.value;
    explanation.parts = std::move(margin.parts);
    return explanation;
  }

  Explanation Conflict(const Pathlet& path) const {
    const auto conflict = FindConflict(world_.rules, before_, path);
    // No conflict on the best path: no edge leads onward.
    if (!conflict) return DeadEnd();
    const double least_m = HardSeparation_m(world_.rules);
    const std::string other = AbbreviateIri(conflict->with_agent);
    Explanation explanation =
        Named("conflict", "m",
              "the best path by way of it comes within " +
                  Short(least_m - conflict->margin) + " m of " + other +
                  (conflict->window < 0
                       ? std::string()
                       : " in window " + std::to_string(conflict->window)) +
                  ", which was committed before; required are " +
                  Short(least_m) + " m.");
    explanation.value = conflict->margin;
    explanation.parts = {
        {least_m, "required distance",
         facts_.Quote({world_.compilation->mission.iri,
                       {"ex:minimumSeparationKm", "ex:separationIsHard"}}),
         "the team keeps " + Short(least_m) + " m apart"},
        {conflict->margin - least_m, "- closest approach",
         CommittedFacts(*conflict), "the distance left to " + other}};
    return explanation;
  }

  kg_compiler::Facts CommittedFacts(
      const kg_selector::Conflict& conflict) const {
    const kg_mission::Agent& other = FindAgent(world_, conflict.with_agent);
    if (world_.run_iri.empty() || conflict.window < 0) {
      return facts_.Quote({other.iri, {"ex:id"}});
    }
    return facts_.Quote({world_.run_iri + "/" + other.id + "/w" +
                             std::to_string(conflict.window),
                         {"ex:forAgent", "ex:waypointWKT"}});
  }

  // Energy of the cheapest path through it, one term per window.
  Explanation Energy(const Pathlet& path) const {
    const double budget_j = member_.rules.energy_budget_j;
    Explanation explanation = Named("energy", "J", "");
    for (std::size_t s = 0; s < path.visits.size(); ++s) {
      const double energy_j = EdgeTaken(member_, path, s).flight.energy_j;
      explanation.value += energy_j;
      explanation.parts.push_back(
          {energy_j, "E",
           facts_.Capabilities(agent_, {"ex:energyPerKm", "ex:hotelLoadW"}),
           "window " + std::to_string(path.visits[s].window) + ": " +
               Short(energy_j / kg_base::kJoulesPerWh) + " Wh"});
    }
    // margin = energy of all windows - budget.
    const double needed_wh = explanation.value / kg_base::kJoulesPerWh;
    explanation.value -= budget_j;
    explanation.parts.push_back(
        {-budget_j, "- energy budget",
         facts_.Capabilities(agent_, {"ex:energyBudget"}) +
             facts_.Quote({std::string(kg_core::kEx) + "state/" + agent_.id,
                           {"ex:energyRemaining"}}),
         "it has " + Short(budget_j / kg_base::kJoulesPerWh) + " Wh"});
    explanation.text += "the cheapest path by way of it takes " +
                        Short(needed_wh) + " Wh, " +
                        Short(explanation.value / kg_base::kJoulesPerWh) +
                        " Wh more than there are.";
    return explanation;
  }

  Explanation DeadEnd() const {
    Explanation explanation =
        Named("dead_end", "1", "no way leads by it through all windows.");
    explanation.parts = {
        {0.0, "edges", facts_.Capabilities(agent_, {"ex:cruiseSpeedKts"}),
         "waypoints that can be reached from it and to it: none of one"}};
    return explanation;
  }

  const PlannedWorld& world_;
  const kg_mission::Agent& agent_;
  const TeamMember& member_;
  const ViaWaypoints& by_;
  std::vector<Pathlet> before_;
  kg_compiler::CitedFacts facts_;
  kg_planner::PathMasks masks_;
};

}  // namespace

Explanation ExplainTaken(const PlannedWorld& world,
                         const kg_mission::Agent& agent, const Visit& visit,
                         const std::string& name) {
  Explanation explanation;
  explanation.verdict = "taken";
  explanation.unit = "reward";
  explanation.value = visit.reward;
  explanation.text = agent.id + " does go to " + name + ", in window " +
                     std::to_string(visit.window) + ".";
  explanation.parts = {{visit.reward, "reward", world.facts().Policy(agent, {}),
                        visit.via.empty() ? "the reward of that visit"
                                          : "the reward of that window, "
                                            "stops included"}};
  return explanation;
}

Explanation ExplainPathVia(const PlannedWorld& world,
                           const kg_mission::Agent& agent,
                           const ViaWaypoints& by) {
  return ViaExplainer(world, agent, by).Explain();
}

}  // namespace kg_selector
