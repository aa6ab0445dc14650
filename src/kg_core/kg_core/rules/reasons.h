// Representation of the reasons for conclusions in the inferred graph.
//
//   <inference/3f..> a ex:Inference ; ex:byRule ex:escalation ;
//       ex:conclusion <statement/a1..> ;
//       prov:wasDerivedFrom <statement/b2..> , <statement/c3..> .
//   <statement/a1..> a rdf:Statement ; rdf:subject ex:alpha ;
//       rdf:predicate ex:mustAvoid ; rdf:object ex:sanctuary ;
//       prov:wasDerivedFrom <inference/3f..> .
//
// Nodes are named by a hash of their content, so equal reasons have equal nodes
// in every store and at all times. A concluded statement links to its own
// inferences; prov:wasDerivedFrom+ ends at asserted statements.

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
  // The triples matched by the rule's WHERE: facts, vocabulary, other
  // conclusions. Sorted by StatementIri, without duplicates.
  std::vector<Triple> premises;
};

// The node IRI of a statement, and that of an inference, computed from its rule
// and statements (its `iri` is ignored).
std::string StatementIri(const Triple& triple);
std::string InferenceIri(const Inference& inference);

// True if `subject` is a node that describes reasons, not the subject of a
// conclusion.
bool IsReason(const Term& subject);

// The statements of `inference` in the inferred graph, including its
// conclusion; statements shared by several inferences are returned for each.
std::vector<Statement> CollectStatements(const Inference& inference);

// The inferences that concluded `triple`, sorted by IRI; empty if it was not
// concluded. The rule's rdfs:label and rdfs:comment explain it in words.
std::vector<Inference> WhyInferred(const GraphView& view, const Triple& triple);

}  // namespace kg_core

#endif  // KG_CORE_RULES_REASONS_H_
