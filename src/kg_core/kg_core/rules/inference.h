// Maintenance of the inferred graph: it always holds the fixed point of the
// rules on facts and vocabulary, and the reasons (reasons.h). It is updated
// within the transaction that changes the facts, so conclusions appear and
// disappear together with their premises.

#ifndef KG_CORE_RULES_INFERENCE_H_
#define KG_CORE_RULES_INFERENCE_H_

#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/rules/conclusion_check.h"
#include "kg_core/rules/fixed_point.h"

namespace kg_core {

// Updates the inferred graph for the changes of `transaction` to facts and
// vocabulary; does nothing if no rule reads any of them. Returns the reasons
// for rejection: an unusable rule, a `forbidden` conclusion
// (conclusion_check.h) or an exceeded limit; the graph is then unchanged.
std::vector<std::string> StageInferences(Transaction& transaction,
                                         ForbiddenTerm forbidden,
                                         const InferenceLimits& limits = {});

}  // namespace kg_core

#endif  // KG_CORE_RULES_INFERENCE_H_
