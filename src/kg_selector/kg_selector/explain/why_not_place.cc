#include "kg_selector/explain/why_not_place.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/geo/geodesy.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/control_plane/proximal_recurrence.h"
#include "kg_compiler/explain/explain_place.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_selector {
namespace {

using kg_compiler::Explanation;
using kg_compiler::Facts;
using kg_compiler::NavGraph;
using kg_compiler::operator+;
using kg_base::LonLat;
using kg_compiler::Short;
using kg_compiler::Waypoint;
using kg_mission::Agent;

// Explains why a reachable place is not a waypoint.
class NotSampled {
 public:
  NotSampled(const PlannedWorld& world, const Agent& agent, LonLat place,
             const NavGraph& graph)
      : world_(world),
        agent_(agent),
        rules_(FindMember(world, agent).rules),
        place_(place),
        graph_(graph),
        facts_(world.facts()) {}

  Explanation Explain() const {
    const Waypoint* near = Nearest();
    const double spacing_m =
        rules_.spacing_m > 0.0 ? rules_.spacing_m : rules_.sensor_radius_m;
    const double away_m =
        near ? kg_base::Distance_m(near->position, place_) : spacing_m;
    return away_m < spacing_m ? TooNear(*near, spacing_m, away_m)
                              : LessResponse();
  }

 private:
  Explanation Named(const char* unit, const std::string& why) const {
    Explanation explanation;
    explanation.verdict = "not_sampled";
    explanation.unit = unit;
    explanation.text = kg_base::PointWkt(place_) + " is no waypoint of " +
                       agent_.id + " in " + "window " +
                       std::to_string(graph_.window) + ": " + why;
    return explanation;
  }

  const Waypoint* Nearest() const {
    const Waypoint* nearest = nullptr;
    double least_m = 0.0;
    for (const Waypoint& waypoint : graph_.waypoints) {
      const double away_m = kg_base::Distance_m(waypoint.position, place_);
      if (nearest && !(away_m < least_m)) continue;
      nearest = &waypoint;
      least_m = away_m;
    }
    return nearest;
  }

  Facts WaypointFacts(const Waypoint& waypoint) const {
    const Facts stated =
        facts_.Quote({std::string(kg_core::kEx) + "nav/" + graph_.hash +
                          "/waypoint/" + std::to_string(waypoint.id),
                      {"ex:score", "geo:asWKT"}});
    return stated.empty() ? facts_.Policy(agent_, {}) : stated;
  }

  Explanation TooNear(const Waypoint& near, double spacing_m,
                      double away_m) const {
    Explanation explanation = Named(
        "m", "waypoint " + std::to_string(near.id) + ", which sees more, is " +
                 Short(away_m / 1e3) + " km away; waypoints lie " +
                 Short(spacing_m / 1e3) + " km apart.");
    explanation.value = spacing_m - away_m;
    explanation.parts = {
        {spacing_m, "spacing",
         facts_.Quote(
             {world_.compilation->mission.iri, {"ex:waypointSpacingKm"}}) +
             facts_.Capabilities(agent_, {"ex:sensorRadiusKm"}),
         "least distance of waypoints"},
        {-away_m, "- distance", WaypointFacts(near),
         "distance to waypoint " + std::to_string(near.id)}};
    return explanation;
  }

  // Footprint cells not yet covered by a waypoint.
  std::vector<int> CellsLeft() const {
    const auto& tensor =
        kg_compiler::FindTensor(*world_.compilation, agent_, graph_.window);
    const auto cell = tensor.grid.CellAt(place_);
    std::vector<int> cells =
        kg_compiler::DiscSum(tensor.grid,
                             tensor.Get(kg_compiler::Layer::kFused), *cell,
                             rules_.sensor_radius_m)
            .footprint;
    std::set<int> counted;
    for (const Waypoint& waypoint : graph_.waypoints) {
      counted.insert(waypoint.footprint.begin(), waypoint.footprint.end());
    }
    cells.erase(std::remove_if(cells.begin(), cells.end(),
                               [&](int i) { return counted.count(i) > 0; }),
                cells.end());
    return cells;
  }

  Explanation LessResponse() const {
    const Waypoint* min_value = &graph_.waypoints.front();
    for (const Waypoint& waypoint : graph_.waypoints) {
      if (waypoint.score < min_value->score) min_value = &waypoint;
    }
    const auto inputs = kg_compiler::FindTensorInputs(*world_.compilation,
                                                      agent_, graph_.window);
    Explanation response =
        kg_compiler::TensorExplainer(inputs, facts_).ExplainSum(CellsLeft());
    // Negative if the place's response exceeds the weakest waypoint's score.
    const double margin = min_value->score - response.value;
    Explanation explanation = Named(
        "reward",
        "what the sensor would see there beside the other waypoints is worth " +
            Short(response.value) + ", the least of the " +
            std::to_string(graph_.waypoints.size()) + " waypoints " +
            Short(min_value->score) + "." +
            (margin < 0.0
                 ? " It was passed over with a better place near it that "
                   "cannot be flown to, or where station cannot be held."
                 : ""));
    explanation.value = margin;
    explanation.parts = {{min_value->score, "score of the last waypoint",
                          WaypointFacts(*min_value),
                          "waypoint " + std::to_string(min_value->id)}};
    for (auto part : response.parts) {
      part.value = -part.value;
      part.term = "- " + part.term;
      explanation.parts.push_back(std::move(part));
    }
    return explanation;
  }

  const PlannedWorld& world_;
  const Agent& agent_;
  const kg_compiler::SeamRules& rules_;
  LonLat place_;
  const NavGraph& graph_;
  kg_compiler::CitedFacts facts_;
};

std::vector<LonLat> StageSources(const TeamMember& member, std::size_t stage) {
  if (stage == 0) return {member.rules.start};
  std::vector<LonLat> sources;
  for (const Waypoint& waypoint : member.graphs[stage - 1].waypoints) {
    sources.push_back(waypoint.position);
  }
  return sources;
}

}  // namespace

Explanation NoWaypointThere(const PlannedWorld& world, const Agent& agent,
                            LonLat place, std::size_t stage) {
  const TeamMember& member = FindMember(world, agent);
  const NavGraph& graph = member.graphs[stage];
  kg_compiler::PlaceQuestion question;
  question.tensor =
      kg_compiler::FindTensorInputs(*world.compilation, agent, graph.window);
  question.seam = kg_compiler::FindSeamContext(*world.compilation, agent,
                                               member.rules, graph.window);
  question.sources = StageSources(member, stage);
  question.place = place;
  const kg_compiler::CitedFacts facts = world.facts();
  auto blocked = kg_compiler::WhyUnreachable(question, facts);
  if (blocked) return std::move(*blocked);
  return NotSampled(world, agent, place, graph).Explain();
}

}  // namespace kg_selector
