// What the query of a rule reads, and what a rule must not ask: whatever would
// make its conclusions depend on chance, on the time, or on more than facts,
// vocabulary and conclusions.

#ifndef KG_CORE_RULES_RULE_ANALYSIS_H_
#define KG_CORE_RULES_RULE_ANALYSIS_H_

#include <vector>

#include "kg_core/rules/triple_kind.h"
#include "kg_core/sparql/query.h"

namespace kg_core {

struct RuleReads {
  std::vector<TripleKind> reads;
  std::vector<TripleKind> negative_reads;
};

// Throws InputError "what is not for rules".
RuleReads AnalyseRule(const sparql::Query& query);

// Likewise for what the template writes.
std::vector<TripleKind> AnalyseTemplate(const sparql::Query& query);

}  // namespace kg_core

#endif  // KG_CORE_RULES_RULE_ANALYSIS_H_
