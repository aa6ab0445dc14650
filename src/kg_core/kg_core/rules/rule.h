// A rule: a SPARQL CONSTRUCT stored as a fact, and the triples it reads and
// writes.
//
//   ex:escalation a ex:Rule ;
//       ex:construct "CONSTRUCT { ?a ex:mustAvoid ?z } WHERE { ... }" .
//
// Reads and writes are known only as kinds of triples: a predicate, plus the
// class if the predicate is rdf:type. See docs/rules.md for what rules may do.

#ifndef KG_CORE_RULES_RULE_H_
#define KG_CORE_RULES_RULE_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"
#include "kg_core/rules/triple_kind.h"
#include "kg_core/sparql/query.h"

namespace kg_core {

struct Rule {
  Term iri;
  sparql::Query query;  // Ready for an Evaluator that emits whole solutions.
  // Kinds read positively: new triples can add solutions, never remove any.
  std::vector<TripleKind> reads;
  // Kinds whose new triples may remove solutions: NOT EXISTS, MINUS, OPTIONAL,
  // aggregates.
  std::vector<TripleKind> negative_reads;
  std::vector<TripleKind> writes;
};

// Throws InputError "ex:R ex:construct: what is wrong".
Rule ParseRule(const Term& iri, const std::string& construct);

// All enabled rules, sorted by IRI; values in the facts take precedence over
// those in the vocabulary. `reasons` gets one line per invalid rule, enabled or
// not.
std::vector<Rule> LoadRules(const GraphView& view,
                            std::vector<std::string>* reasons);

// True if `statement` is part of the definition of a rule.
bool DefinesRules(const Statement& statement);

}  // namespace kg_core

#endif  // KG_CORE_RULES_RULE_H_
