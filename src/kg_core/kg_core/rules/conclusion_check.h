// What rules may not conclude: words that nobody knows, and facts that others
// act on before the rules run.

#ifndef KG_CORE_RULES_CONCLUSION_CHECK_H_
#define KG_CORE_RULES_CONCLUSION_CHECK_H_

#include <string>
#include <vector>

#include "kg_core/facts/vocabulary.h"
#include "kg_core/rules/reasons.h"
#include "kg_core/rules/rule.h"

namespace kg_core {

// Before a rule is run, as far as its template shows it: a reason for each word
// that is no word of `vocabulary`, and for each that is forbidden.
void CheckWritten(const std::vector<Rule>& rules, const Vocabulary& vocabulary,
                  std::vector<std::string>* reasons);

// Once it has concluded something: throws InputError if that is forbidden.
void CheckConclusion(const Inference& inference);

}  // namespace kg_core

#endif  // KG_CORE_RULES_CONCLUSION_CHECK_H_
