#include "kg_mission/mission/agent_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "kg_base/common/units.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rules/reasons.h"
#include "kg_mission/mission/choice.h"
#include "kg_mission/mission/policy_reader.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::GraphView;
using kg_core::Iri;
using kg_core::Term;

constexpr NamedChoice<Mobility> kMobilities[] = {
    {"glider", Mobility::kGlider},
    {"fixed_wing", Mobility::kFixedWing},
    {"hover", Mobility::kHover}};

// The sources of a statement: its subject if asserted, and the inferences that
// conclude it.
std::vector<std::string> CollectSources(const GraphView& asserted,
                                        const kg_core::Triple& triple) {
  std::vector<std::string> sources;
  if (kg_core::Has(asserted, kg_core::kFactsGraph, triple.subject,
                   triple.predicate, triple.object)) {
    sources.push_back(triple.subject.text);
  }
  for (kg_core::Inference& inference : kg_core::WhyInferred(asserted, triple)) {
    sources.push_back(std::move(inference.iri));
  }
  return sources;
}

// The agent's state for the earliest window.
FactEntity FindStart(const GraphView& view, const WindowCalendar& calendar,
                     const FactEntity& agent) {
  std::vector<std::pair<int, FactEntity>> states;
  for (const Term& term :
       kg_core::FindInstances(view, kg_core::kFactsGraph, Ex("AgentState"))) {
    const FactEntity state(view, term);
    if (state.Iris(Ex("forAgent")) != std::vector<std::string>{agent.iri()}) {
      continue;
    }
    states.emplace_back(calendar.FindWindow(state), state);
  }
  const Term state = Ex("AgentState");
  if (states.empty()) {
    agent.Refuse(state, "an ex:AgentState with ex:forAgent " +
                            kg_core::ToTurtle(agent.subject()) +
                            " to start from");
  }
  // The agent starts in the earliest window that has a state.
  std::stable_sort(
      states.begin(), states.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
  if (states.size() > 1 && states[0].first == states[1].first) {
    agent.Refuse(state, "one state for window " +
                            std::to_string(states[0].first) + ", not two");
  }
  return states[0].second;
}

Agent ReadAgent(const GraphView& asserted, const GraphView& view,
                const WindowCalendar& calendar, const FactEntity& entity) {
  Agent agent;
  agent.iri = entity.iri();
  agent.id = entity.Text(Ex("id"));
  agent.mobility =
      Choice(entity, Ex("mobility"), kMobilities, Mobility::kGlider);
  agent.policy = ReadPolicy(view, entity.Follow(Ex("usesPolicy")));
  agent.capabilities = ReadCapabilities(entity.Follow(Ex("hasCapabilities")));
  const FactEntity start = FindStart(view, calendar, entity);
  agent.start = start.Position();
  agent.start_heading_rad =
      kg_base::DegToRad(start.Number(Ex("headingDeg"), 0.0));
  agent.start_iri = start.iri();
  if (const auto wh = start.MaybeNumber(Ex("energyRemaining"))) {
    agent.start_energy_j = kg_base::WhToJoules(*wh);
  }
  for (const std::string& zone : entity.Iris(Ex("mustAvoid"))) {
    agent.must_avoid[zone] =
        CollectSources(asserted, {Iri(agent.iri), Ex("mustAvoid"), Iri(zone)});
  }
  return agent;
}

}  // namespace

std::vector<Agent> ReadAgents(const GraphView& asserted, const GraphView& view,
                              const WindowCalendar& calendar,
                              const FactEntity& mission) {
  std::vector<Agent> agents;
  for (const Term& term : mission.All(Ex("hasAgent"))) {
    agents.push_back(
        ReadAgent(asserted, view, calendar, FactEntity(view, term)));
  }
  if (agents.empty()) mission.Refuse(Ex("hasAgent"), "at least one agent");
  std::sort(agents.begin(), agents.end(),
            [](const Agent& a, const Agent& b) { return a.id < b.id; });
  const auto twin = std::adjacent_find(
      agents.begin(), agents.end(),
      [](const Agent& a, const Agent& b) { return a.id == b.id; });
  if (twin != agents.end()) {
    FactEntity(view, Iri(twin->iri))
        .Refuse(Ex("id"), "a unique id, not \"" + twin->id + "\" twice");
  }
  return agents;
}

}  // namespace kg_mission
