// A world with its plan, as one immutable value: the input of all explanations.
// Facts, compilation, waypoint graphs and the selector's decisions, all of one
// world version.

#ifndef KG_SELECTOR_EXPLAIN_PLANNED_WORLD_H_
#define KG_SELECTOR_EXPLAIN_PLANNED_WORLD_H_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/explain/cited_facts.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_selector/team/plan_team.h"

namespace kg_selector {

struct PlannedWorld {
  std::shared_ptr<const kg_core::GraphView> view;  // The facts.
  std::shared_ptr<const kg_compiler::Compilation> compilation;
  TeamRules rules;
  std::vector<TeamMember> members;  // Each with the graphs received so far.
  bool has_plan = false;
  TeamPlan plan;        // Agents by IRI. Tracks may be missing in rejections.
  std::string run_iri;  // The ex:PlanRun; empty if it is not among the facts.
  std::string plan_graph;
  // Agents that visited each event in a past window, by event IRI.
  std::map<std::string, std::vector<std::string>> past_visits;

  kg_compiler::CitedFacts facts() const {
    return kg_compiler::CitedFacts(*view, plan_graph);
  }
};

// Replaces agents' ex:id, which planners and selectors may use as names, by
// their IRIs.
void NameAgentsByIri(PlannedWorld* world);

// Finds an agent by ex:id, "ex:alpha" or IRI. Throws kg_base::InputError
// listing the known agents.
const kg_mission::Agent& FindAgent(const PlannedWorld& world,
                                   const std::string& name);
// The agent's member, with a graph for each of its windows. Throws
// kg_base::InputError if graphs are still missing.
const TeamMember& FindMember(const PlannedWorld& world,
                             const kg_mission::Agent& agent);
// Index of a window in the member's graphs; throws kg_base::InputError if there
// is none.
std::size_t FindStage(const TeamMember& member, int window);
// The path committed for an agent; null = none.
const Pathlet* FindPath(const PlannedWorld& world,
                        const std::string& agent_iri);
// The path committed for an agent; throws kg_base::InputError with the reason
// if it has none.
const Pathlet& NeedPath(const PlannedWorld& world,
                        const kg_mission::Agent& agent);
// Paths committed before an agent's path, in order; all if it has none.
std::vector<Pathlet> CommittedBefore(const PlannedWorld& world,
                                     const std::string& agent_iri);
// The edge that a path takes into the stage's window. Throws std::logic_error
// if its graph does not have it.
const kg_compiler::TraverseEdge& EdgeTaken(const TeamMember& member,
                                           const Pathlet& pathlet,
                                           std::size_t stage);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_PLANNED_WORLD_H_
