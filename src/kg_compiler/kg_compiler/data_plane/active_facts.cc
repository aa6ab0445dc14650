#include "kg_compiler/data_plane/active_facts.h"

#include <algorithm>

#include "kg_mission/mission/scope.h"

namespace kg_compiler {
namespace {

std::string WeightIri(const kg_mission::Policy& policy,
                      const std::string& key) {
  const auto found = policy.weight_iris.find(key);
  return found == policy.weight_iris.end() ? "" : found->second;
}

ActiveConstraint Activate(const kg_mission::Constraint& fact,
                          const kg_mission::Agent& agent) {
  ActiveConstraint active;
  active.fact = &fact;
  active.effect = &kg_mission::EffectOf(fact.kind);
  if (active.forbids()) return active;
  // The policy's factor overrides the constraint's (A11).
  const auto& overrides = agent.policy.soft_overrides;
  const auto found = overrides.find(fact.iri);
  if (found == overrides.end()) {
    active.attenuation = fact.attenuation;
  } else {
    active.attenuation = found->second;
    active.override_iri = WeightIri(agent.policy, fact.iri);
  }
  const auto avoided = agent.must_avoid.find(fact.iri);
  if (avoided == agent.must_avoid.end()) return active;
  active.effect = &kg_mission::EffectOf(active.effect->when_avoided);
  active.avoided_by = avoided->second;
  return active;
}

void FindPriors(const kg_mission::Mission& mission,
                const kg_mission::Agent& agent, int window,
                ActiveFacts* active) {
  for (const kg_mission::PriorLayer& prior : mission.priors) {
    const auto beta = agent.policy.beta.find(prior.iri);
    if (beta == agent.policy.beta.end() || beta->second == 0.0) continue;
    if (!kg_mission::InScope(prior.windows, window)) continue;
    if (!kg_mission::InScope(prior.agents, agent.iri)) continue;
    active->priors.push_back(
        {&prior, beta->second, WeightIri(agent.policy, prior.iri)});
    active->names_agent |= !prior.agents.empty();
  }
}

}  // namespace

ActiveFacts FindActiveFacts(const kg_mission::Mission& mission,
                            const kg_mission::Agent& agent,
                            const kg_mission::TimeWindow& window) {
  ActiveFacts active;
  const kg_mission::Policy& policy = agent.policy;
  active.reads_value = policy.alpha_base != 0.0 || policy.gamma_front != 0.0;
  for (const kg_mission::Constraint& constraint : mission.constraints) {
    if (!constraint.AppliesTo(agent.iri, window.index)) continue;
    active.constraints.push_back(Activate(constraint, agent));
    active.names_agent |= !constraint.agents.empty();
  }
  FindPriors(mission, agent, window.index, &active);
  if (policy.beta_poi == 0.0) return active;
  for (const kg_mission::Event& event : mission.events) {
    const bool is_on = std::find(event.windows.begin(), event.windows.end(),
                                 window.index) != event.windows.end();
    if (is_on) active.events.push_back(&event);
  }
  return active;
}

}  // namespace kg_compiler
