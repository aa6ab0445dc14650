#include <utility>

#include "kg_core/rdf/namespaces.h"
#include "kg_selector/explain/explain_plan.h"

namespace kg_selector {
namespace {

using kg_compiler::Explanation;
using kg_compiler::Facts;
using kg_compiler::Short;
using kg_compiler::Signed;
using kg_core::AbbreviateIri;
using kg_mission::Agent;

class RejectionExplainer {
 public:
  RejectionExplainer(const PlannedWorld& world, const RejectedPath& rejection)
      : world_(world),
        rejection_(rejection),
        conflict_(rejection.conflict),
        facts_(world.facts()) {
    explanation_.value = conflict_.margin;
    explanation_.verdict = Name(conflict_.kind);
  }

  Explanation Explain() {
    switch (conflict_.kind) {
      case ConflictKind::kSeparation:
        AddSeparation();
        break;
      case ConflictKind::kCapacity:
        AddCapacity();
        break;
      case ConflictKind::kEnergy:
        AddEnergy();
        break;
      case ConflictKind::kOutbid:
        AddOutbid();
        break;
      case ConflictKind::kExpired:
        explanation_.unit = "windows";
        explanation_.parts = {{conflict_.margin, "windows too late",
                               facts_.Event(conflict_.event),
                               rejection_.reason}};
        break;
      case ConflictKind::kMalformed:  // No values to explain.
        break;
    }
    explanation_.text = "A path of " + AbbreviateIri(rejection_.pathlet.agent) +
                        " worth " + Short(rejection_.pathlet.score()) +
                        " lost in round " + std::to_string(rejection_.round) +
                        ": " + rejection_.reason + "." + Instead();
    return std::move(explanation_);
  }

 private:
  std::string Instead() const {
    const Pathlet* got = FindPath(world_, rejection_.pathlet.agent);
    if (got == nullptr) return " It has no other path.";
    return " The path it has instead is worth " +
           Signed(got->score() - rejection_.pathlet.score()) +
           " compared with it.";
  }

  Facts Winner() const {
    const std::string run = world_.run_iri;
    if (run.empty() || conflict_.window < 0 || conflict_.with_agent.empty()) {
      return {};
    }
    const Agent& agent = FindAgent(world_, conflict_.with_agent);
    return facts_.Quote(
        {run + "/" + agent.id + "/w" + std::to_string(conflict_.window),
         {"ex:forAgent", "ex:waypointWKT", "ex:visits"}});
  }

  void AddSeparation() {
    const double least_m = HardSeparation_m(world_.rules);
    explanation_.unit = "m";
    explanation_.parts = {
        {least_m, "required distance",
         facts_.Quote({world_.compilation->mission.iri,
                       {"ex:minimumSeparationKm", "ex:separationIsHard"}}),
         "the team keeps " + Short(least_m) + " m apart"},
        {conflict_.margin - least_m, "- closest approach", Winner(),
         "it would have come within " + Short(least_m - conflict_.margin) +
             " m of " + AbbreviateIri(conflict_.with_agent)}};
  }

  // margin = capacity - agents that the event rewards, including this one.
  void AddCapacity() {
    const auto capacity = world_.rules.event_capacity.find(conflict_.event);
    const double places =
        capacity == world_.rules.event_capacity.end() ? 0.0 : capacity->second;
    const std::string name = AbbreviateIri(conflict_.event);
    const double others = places - 1.0 - conflict_.margin;
    explanation_.unit = "agents";
    explanation_.parts = {
        {places, "capacity", facts_.Event(conflict_.event),
         name + " has that many places left"},
        {-others, "- committed", Winner(),
         "taken by paths committed before, the last " +
             AbbreviateIri(conflict_.with_agent) + "'s"},
        {-1.0, "- itself", facts_.Quote({rejection_.pathlet.agent, {"ex:id"}}),
         "the path itself"}};
  }

  void AddEnergy() {
    const Agent& agent = FindAgent(world_, rejection_.pathlet.agent);
    const TeamMember& member = FindMember(world_, agent);
    const double budget_j = member.rules.energy_budget_j;
    explanation_.unit = "J";
    explanation_.parts = {
        {budget_j + conflict_.margin,
         "energy of the path",
         {},
         "what its ways take"},
        {-budget_j, "- what is left",
         facts_.Quote({agent.capabilities.iri, {"ex:energyBudget"}}),
         "of the energy budget"}};
  }

  // margin = score lost against the path it got.
  void AddOutbid() {
    const double score = rejection_.pathlet.score();
    explanation_.unit = "reward";
    explanation_.parts = {
        {score, "the path", Quoted(rejection_.pathlet.agent),
         "reward less cost of the path that lost"},
        {conflict_.margin - score, "- what it got",
         Quoted(rejection_.pathlet.agent),
         "with what the others then have, the team is worth more"}};
  }
  Facts Quoted(const std::string& agent) const {
    return facts_.Quote({agent, {"ex:id", "ex:usesPolicy"}});
  }

  const PlannedWorld& world_;
  const RejectedPath& rejection_;
  const Conflict& conflict_;
  kg_compiler::CitedFacts facts_;
  Explanation explanation_;
};

}  // namespace

Explanation ExplainRejection(const PlannedWorld& world, std::size_t number) {
  return RejectionExplainer(world, world.plan.rejections.at(number)).Explain();
}

}  // namespace kg_selector
