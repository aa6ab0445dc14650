// What the rules conclude, kept in step with the facts: the graph `inferred`
// always holds the fixed point of the rules on facts and vocabulary, and the
// reasons (reasons.h). It is brought up to date within the transaction that
// changes the facts, so conclusions come and go with what they follow from.

#ifndef KG_CORE_RULES_INFERENCE_H_
#define KG_CORE_RULES_INFERENCE_H_

#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/rules/conclusion_check.h"
#include "kg_core/rules/fixed_point.h"

namespace kg_core {

// Brings the graph `inferred` up to date with what `transaction` changed in
// facts and vocabulary; does nothing if no rule reads any of it. Returns the
// reasons to refuse: a rule that cannot be used, a conclusion that is
// `forbidden` (conclusion_check.h), or a limit that was hit; the graph is then
// as it was.
std::vector<std::string> StageInferences(Transaction& transaction,
                                         ForbiddenTerm forbidden,
                                         const InferenceLimits& limits = {});

}  // namespace kg_core

#endif  // KG_CORE_RULES_INFERENCE_H_
