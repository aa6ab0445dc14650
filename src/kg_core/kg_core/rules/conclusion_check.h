// What rules may not conclude: terms that the vocabulary does not have, rules,
// reasons, and what the caller forbids.

#ifndef KG_CORE_RULES_CONCLUSION_CHECK_H_
#define KG_CORE_RULES_CONCLUSION_CHECK_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/term.h"
#include "kg_core/rules/reasons.h"
#include "kg_core/rules/rule.h"

namespace kg_core {

// The reason why no rule may conclude this property or class; nothing if rules
// may.
using ForbiddenTerm =
    absl::FunctionRef<std::optional<std::string>(const Term& term)>;

// Before a rule is run, as far as its template shows it: a reason for each
// property or class that `vocabulary` does not have, and for each that is
// forbidden.
void CheckWritten(const std::vector<Rule>& rules, const Vocabulary& vocabulary,
                  ForbiddenTerm forbidden, std::vector<std::string>* reasons);

// Once a rule has concluded something: throws InputError if it is forbidden.
void CheckConclusion(const Inference& inference, ForbiddenTerm forbidden);

}  // namespace kg_core

#endif  // KG_CORE_RULES_CONCLUSION_CHECK_H_
