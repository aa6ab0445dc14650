// Validation of the rules' conclusions. They must satisfy the same checks as
// facts from an operator, because they are read and used in planning like any
// other fact.

#ifndef KG_MISSION_MISSION_CONCLUSIONS_H_
#define KG_MISSION_MISSION_CONCLUSIONS_H_

#include <string>
#include <vector>

#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_mission {

// Reasons to reject the conclusions in `view`, whose facts alone are valid: the
// findings of statement_check.h and of the shapes on facts and conclusions
// together. Each names the rules that may be responsible.
std::vector<std::string> CheckConclusions(const kg_core::Vocabulary& vocabulary,
                                          const kg_core::GraphView& view);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_CONCLUSIONS_H_
