// CONSTRUCT and DESCRIBE, and the templates of CONSTRUCT and of updates: rules
// [10], [11], [52] and [73] to [77].

#include "kg_core/sparql/algebra.h"
#include "kg_core/sparql/grammar.h"

namespace kg_core::sparql {

// Call right after consuming the token that creates a blank node.
void SparqlGrammar::CheckBlankAllowed() const {
  if (template_.blank_nodes) return;
  Fail(tokens_[at_ - 1],
       std::string(template_.name) + " may not have blank nodes");
}

// [52] TriplesTemplate in braces, with its own scope of blank node labels.
GraphPattern SparqlGrammar::ReadTemplateTriples(const TemplateRules& rules) {
  const Nested nested(this);
  const TemplateRules outer = template_;
  ExpectMark("{");
  template_ = rules;
  GraphPattern basic;
  ReadTriplesBlock(&basic);
  template_ = outer;
  ExpectMark("}");
  return basic;
}

// Restricts the projection to the variables mentioned in the templates.
void SparqlGrammar::AddTemplateColumns(
    const std::vector<QuadTemplate>& templates) {
  VariableSet variables;
  for (const QuadTemplate& quad : templates) {
    const TriplePattern& triple = quad.triple;
    for (const VarOrTerm& node :
         {triple.subject, triple.predicate, triple.object, quad.graph}) {
      if (node.is_variable) variables.Insert(node.index);
    }
  }
  AddColumns(variables, &query_.select);
}

// [50] Quads in braces.
std::vector<QuadTemplate> SparqlGrammar::ReadQuads(const TemplateRules& rules) {
  const Nested nested(this);
  std::vector<QuadTemplate> quads;
  ExpectMark("{");
  template_ = rules;
  ReadQuadTriples({}, &quads);
  // [51] QuadsNotTriples, with optional triples after each.
  while (TakeWord("GRAPH")) {
    const VarOrTerm graph = Peek().kind == Token::Kind::kVariable
                                ? VarOrTerm{true, ReadVariable()}
                                : ConstantNode(Iri(ReadIri()));
    ExpectMark("{");
    ReadQuadTriples(graph, &quads);
    ExpectMark("}");
    TakeMark(".");
    ReadQuadTriples({}, &quads);
  }
  template_ = {};
  ExpectMark("}");
  return quads;
}

void SparqlGrammar::ReadQuadTriples(const VarOrTerm& graph,
                                    std::vector<QuadTemplate>* quads) {
  GraphPattern basic;
  ReadTriplesBlock(&basic);
  for (TriplePattern& triple : basic.triples) {
    quads->push_back({std::move(triple), graph});
  }
}

// [10] ConstructQuery
void SparqlGrammar::ReadConstruct() {
  TemplateRules rules;
  rules.active = true;
  // The short form CONSTRUCT WHERE { ... } uses the pattern as its template.
  const bool full = AtMark("{");
  if (!full) {
    ReadDatasetClauses();
    ExpectWord("WHERE");
  }
  GraphPattern triples = ReadTemplateTriples(rules);
  for (const TriplePattern& triple : triples.triples) {
    if (!full) CountPattern();
    query_.construct.push_back({triple, {}});
  }
  if (full) {
    // Template and pattern have separate scopes of blank node labels.
    block_of_label_.clear();
    block_ = ++blocks_;
    ReadDatasetClauses();
    ReadWhere(&query_.select);
  } else {
    query_.select.where = std::move(triples);
  }
  AddTemplateColumns(query_.construct);
  ReadModifiersOfForm();
}

// [11] DescribeQuery
void SparqlGrammar::ReadDescribe() {
  const bool all = TakeMark("*");
  while (!all && (AtIri() || Peek().kind == Token::Kind::kVariable)) {
    query_.describe.push_back(ReadVariableOrTerm());
  }
  if (!all && query_.describe.empty()) Expected("an IRI, a variable or '*'");
  ReadDatasetClauses();
  SelectQuery* const select = &query_.select;
  if (AtWord("WHERE") || AtMark("{")) ReadWhere(select);
  VariableSet wanted;
  for (const VarOrTerm& node : query_.describe) {
    if (node.is_variable) wanted.Insert(node.index);
  }
  AddColumns(all ? VisibleVariables(select->where) : wanted, select);
  for (const SelectColumn& column : select->columns) {
    if (all) query_.describe.push_back({true, column.variable});
  }
  ReadModifiersOfForm();
}

}  // namespace kg_core::sparql
