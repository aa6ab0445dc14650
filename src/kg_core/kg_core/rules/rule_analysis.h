// Static analysis of rule queries: the triples read, and rejection of
// constructs that would make conclusions depend on chance, time, or anything
// but facts, vocabulary and conclusions.

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

// Throws InputError that names the construct not allowed in rules.
RuleReads AnalyseRule(const sparql::Query& query);

// The kinds of triples written by the template; throws likewise.
std::vector<TripleKind> AnalyseTemplate(const sparql::Query& query);

}  // namespace kg_core

#endif  // KG_CORE_RULES_RULE_ANALYSIS_H_
