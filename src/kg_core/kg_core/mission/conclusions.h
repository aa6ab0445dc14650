// What rules conclude must be such that an operator might have written it: it
// is read and planned with like any other fact.

#ifndef KG_CORE_MISSION_CONCLUSIONS_H_
#define KG_CORE_MISSION_CONCLUSIONS_H_

#include <string>
#include <vector>

#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_core {

// Reasons to refuse the conclusions in `view`, whose facts alone are fine: what
// statement_check.h or a shape says of facts and conclusions together. Each
// names the rules that may be to blame.
std::vector<std::string> CheckConclusions(const Vocabulary& vocabulary,
                                          const GraphView& view);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_CONCLUSIONS_H_
