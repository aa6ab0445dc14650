#include "kg_engine/terms/plan_names.h"

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_engine {

using kg_core::Iri;
using kg_core::Term;

Term PlanGraph(unsigned long long run) {
  return Iri(kg_core::kPlanGraphPrefix + std::to_string(run));
}

Term PlanRunNode(unsigned long long run) {
  return kg_core::Ex("plan/" + std::to_string(run));
}

Term SelectRunNode(unsigned long long run) {
  return Iri(PlanRunNode(run).text + "/select");
}

Term AssignmentNode(unsigned long long run, const std::string& agent_id,
                    int window) {
  return Iri(PlanRunNode(run).text + "/" + agent_id + "/w" +
             std::to_string(window));
}

}  // namespace kg_engine
