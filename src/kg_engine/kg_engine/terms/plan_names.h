// IRIs of the facts of a plan run. They depend on numbers and ids only, so
// references to a plan need nothing else.
//
//   ex:graph\/plan\/7        the graph that holds run 7 alone
//   ex:plan\/7               its ex:PlanRun
//   ex:plan\/7\/select       its ex:SelectRun
//   ex:plan\/7\/alpha\/w2    the ex:Assignment of an agent in a window

#ifndef KG_ENGINE_TERMS_PLAN_NAMES_H_
#define KG_ENGINE_TERMS_PLAN_NAMES_H_

#include <string>

#include "kg_core/rdf/term.h"

namespace kg_engine {

kg_core::Term PlanGraph(unsigned long long run);
kg_core::Term PlanRunNode(unsigned long long run);
kg_core::Term SelectRunNode(unsigned long long run);
// `agent_id` is the agent's ex:id.
kg_core::Term AssignmentNode(unsigned long long run,
                             const std::string& agent_id, int window);

}  // namespace kg_engine

#endif  // KG_ENGINE_TERMS_PLAN_NAMES_H_
