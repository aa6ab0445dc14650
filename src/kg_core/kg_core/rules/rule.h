// A rule: a SPARQL CONSTRUCT kept as a fact, and what it reads and writes.
//
//   ex:escalation a ex:Rule ;
//       ex:construct "CONSTRUCT { ?a ex:mustAvoid ?z } WHERE { ... }" .
//
// What it reads and writes is known by kinds of triples only: a predicate, and
// the class where that is rdf:type. docs/rules.md says what rules may do.

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
  // Of a new triple of this kind come more solutions, never fewer.
  std::vector<TripleKind> reads;
  // Of this kind may come fewer: NOT EXISTS, MINUS, OPTIONAL, aggregates.
  std::vector<TripleKind> negative_reads;
  std::vector<TripleKind> writes;
};

// Throws InputError "ex:R ex:construct: what is wrong".
Rule ParseRule(const Term& iri, const std::string& construct);

// All rules that are enabled, by IRI; a value in the facts goes before one of
// the vocabulary. `reasons` gets a line for each that is no rule, enabled or
// not.
std::vector<Rule> LoadRules(const GraphView& view,
                            std::vector<std::string>* reasons);

// Does `statement` say which rules there are, and what they do?
bool DefinesRules(const Statement& statement);

}  // namespace kg_core

#endif  // KG_CORE_RULES_RULE_H_
