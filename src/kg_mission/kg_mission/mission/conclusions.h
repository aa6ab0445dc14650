// What rules conclude must be such that an operator might have written it: it
// is read and planned with like any other fact.

#ifndef KG_MISSION_MISSION_CONCLUSIONS_H_
#define KG_MISSION_MISSION_CONCLUSIONS_H_

#include <string>
#include <vector>

#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_mission {

// Reasons to refuse the conclusions in `view`, whose facts alone are fine: what
// statement_check.h or a shape says of facts and conclusions together. Each
// names the rules that may be to blame.
std::vector<std::string> CheckConclusions(const kg_core::Vocabulary& vocabulary,
                                          const kg_core::GraphView& view);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_CONCLUSIONS_H_
