// How the graph `inferred` says why something was concluded.
//
//   <inference/3f..> a ex:Inference ; ex:byRule ex:escalation ;
//       ex:conclusion <statement/a1..> ;
//       prov:wasDerivedFrom <statement/b2..> , <statement/c3..> .
//   <statement/a1..> a rdf:Statement ; rdf:subject ex:alpha ;
//       rdf:predicate ex:mustAvoid ; rdf:object ex:sanctuary ;
//       prov:wasDerivedFrom <inference/3f..> .
//
// Nodes are named by what they say, so the same reasons are the same nodes, in
// every store and at all times. A statement that is itself concluded leads on
// to its own inferences; prov:wasDerivedFrom+ ends at asserted ones.

#ifndef KG_CORE_RULES_REASONS_H_
#define KG_CORE_RULES_REASONS_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/sparql/query_result.h"

namespace kg_core {

struct Inference {
  std::string iri;
  std::string rule_iri;
  Triple conclusion;
  // What the rule's WHERE matched: facts, vocabulary, other conclusions. Sorted
  // by StatementIri, each once.
  std::vector<Triple> premises;
};

// The name of a statement as a node; that of an inference, whose `iri` does not
// matter, from its rule and statements.
std::string StatementIri(const Triple& triple);
std::string InferenceIri(const Inference& inference);

// Is `subject` a node of reasons, not of conclusions?
bool IsReason(const Term& subject);

// What the graph `inferred` holds of `inference`, its conclusion included;
// statements that several share are in each.
std::vector<Statement> CollectStatements(const Inference& inference);

// All there is on why `triple` was concluded, by IRI; empty if it was not. The
// rule's rdfs:label and rdfs:comment say it in words.
std::vector<Inference> WhyInferred(const GraphView& view, const Triple& triple);

}  // namespace kg_core

#endif  // KG_CORE_RULES_REASONS_H_
