// Checks for conclusions that rules may not draw: terms not in the vocabulary,
// rules, reasons, and terms forbidden by the caller.

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

// Returns the reason why no rule may conclude this property or class; nullopt
// if rules may.
using ForbiddenTerm =
    absl::FunctionRef<std::optional<std::string>(const Term& term)>;

// Static check of the rules' templates: gives a reason for each property or
// class that is not in `vocabulary`, and for each that is forbidden.
void CheckWritten(const std::vector<Rule>& rules, const Vocabulary& vocabulary,
                  ForbiddenTerm forbidden, std::vector<std::string>* reasons);

// Check of an actual conclusion: throws InputError if it is forbidden.
void CheckConclusion(const Inference& inference, ForbiddenTerm forbidden);

}  // namespace kg_core

#endif  // KG_CORE_RULES_CONCLUSION_CHECK_H_
