// Update requests, rules [29] to [51].

#include <utility>

#include "kg_core/sparql/grammar.h"
#include "kg_core/sparql/lexer.h"
#include "kg_core/sparql/parser.h"

namespace kg_core::sparql {
namespace {

using OperationKind = UpdateOperation::Kind;

struct GraphWord {
  const char* word;
  OperationKind kind;
};
constexpr GraphWord kGraphWords[] = {
    {"LOAD", OperationKind::kLoad}, {"CLEAR", OperationKind::kClear},
    {"DROP", OperationKind::kDrop}, {"CREATE", OperationKind::kCreate},
    {"COPY", OperationKind::kCopy}, {"MOVE", OperationKind::kMove},
    {"ADD", OperationKind::kAdd},
};

// DELETE WHERE: the quads serve as both pattern and template.
GraphPattern MakePattern(const QuadTemplate& quad) {
  GraphPattern basic;
  basic.triples.push_back(quad.triple);
  if (quad.graph.index == kNone) return basic;
  GraphPattern graph;
  graph.kind = GraphPattern::Kind::kGraph;
  graph.graph = quad.graph;
  graph.parts.push_back(std::move(basic));
  return graph;
}

bool SameGraph(const VarOrTerm& a, const VarOrTerm& b) {
  return a.is_variable == b.is_variable && a.index == b.index;
}

}  // namespace

// [29] Update, [30] Update1
UpdateRequest SparqlGrammar::ReadUpdate() {
  UpdateRequest update;
  ReadPrologue();
  while (Peek().kind != Token::Kind::kEnd) {
    update.operations.push_back(ReadOperation());
    if (!TakeMark(";")) break;
    ReadPrologue();
  }
  if (Peek().kind != Token::Kind::kEnd) {
    Expected("';' or the end of the update");
  }
  return update;
}

// Each operation has its own variable numbers; prefixes and base are kept.
void SparqlGrammar::BeginOperation() {
  Query fresh;
  fresh.base = query_.base;
  query_ = std::move(fresh);
  variable_numbers_.clear();
  constant_numbers_.clear();
  block_ = ++blocks_;
}

UpdateOperation SparqlGrammar::ReadOperation() {
  BeginOperation();
  UpdateOperation operation;
  operation.position = Peek().position;
  if (ReadGraphOperation(&operation)) return operation;
  if (AtWord("INSERT") && AtWord("DATA", 1)) {
    ReadInsertData(&operation);
  } else if (AtWord("DELETE") && AtWord("DATA", 1)) {
    Take();
    Take();
    operation.removed = ReadQuads({true, false, false, "DELETE DATA"});
  } else if (AtWord("DELETE") && AtWord("WHERE", 1)) {
    ReadDeleteWhere(&operation);
  } else if (AtWord("WITH") || AtWord("DELETE") || AtWord("INSERT")) {
    ReadModify(&operation);
  } else {
    Expected("an update such as INSERT, DELETE, CLEAR or COPY");
  }
  // The next operation starts with an empty query but keeps BASE.
  operation.query = std::move(query_);
  query_ = {};
  query_.base = operation.query.base;
  return operation;
}

// [31] Load to [37] Copy
bool SparqlGrammar::ReadGraphOperation(UpdateOperation* operation) {
  const GraphWord* found = nullptr;
  for (const GraphWord& graph_word : kGraphWords) {
    if (AtWord(graph_word.word)) found = &graph_word;
  }
  if (found == nullptr) return false;
  Take();
  operation->kind = found->kind;
  operation->silent = TakeWord("SILENT");
  // Operands: source TO target, IRI [INTO target], or just a target.
  const bool moves = found->kind == OperationKind::kCopy ||
                     found->kind == OperationKind::kMove ||
                     found->kind == OperationKind::kAdd;
  if (moves) {
    operation->source = ReadGraphRef(found->kind);
    ExpectWord("TO");
  } else if (found->kind == OperationKind::kLoad) {
    operation->source = {GraphRef::Kind::kIri, ReadIri()};
    if (!TakeWord("INTO")) return true;
  }
  operation->target = ReadGraphRef(found->kind);
  return true;
}

// [44] GraphRef, [45] GraphOrDefault, [47] GraphRefAll
GraphRef SparqlGrammar::ReadGraphRef(UpdateOperation::Kind kind) {
  const bool may_be_all =
      kind == OperationKind::kClear || kind == OperationKind::kDrop;
  const bool moves = kind == OperationKind::kCopy ||
                     kind == OperationKind::kMove ||
                     kind == OperationKind::kAdd;
  GraphRef graph;
  // CREATE and LOAD accept only GRAPH <iri>.
  if ((may_be_all || moves) && TakeWord("DEFAULT")) return graph;
  if (may_be_all && TakeWord("NAMED")) {
    graph.kind = GraphRef::Kind::kNamed;
    return graph;
  }
  if (may_be_all && TakeWord("ALL")) {
    graph.kind = GraphRef::Kind::kAll;
    return graph;
  }
  if (!TakeWord("GRAPH") && !moves) {
    Expected(may_be_all ? "GRAPH, DEFAULT, NAMED or ALL" : "GRAPH");
  }
  graph.kind = GraphRef::Kind::kIri;
  graph.iri = ReadIri();
  return graph;
}

// [38] InsertData. A blank node label must not be reused in another INSERT
// DATA. https://www.w3.org/TR/sparql11-query/#grammarBNodes
void SparqlGrammar::ReadInsertData(UpdateOperation* operation) {
  Take();
  Take();
  std::swap(block_of_label_, block_of_data_label_);
  operation->added = ReadQuads({true, false, true, "INSERT DATA"});
  std::swap(block_of_label_, block_of_data_label_);
}

// [40] DeleteWhere
void SparqlGrammar::ReadDeleteWhere(UpdateOperation* operation) {
  Take();
  Take();
  operation->removed = ReadQuads({true, true, false, "DELETE WHERE"});
  GraphPattern where;
  for (const QuadTemplate& quad : operation->removed) {
    CountPattern();
    GraphPattern part = MakePattern(quad);
    // Consecutive quads of one graph form one basic graph pattern.
    const bool same = &quad != operation->removed.data() &&
                      SameGraph(quad.graph, (&quad)[-1].graph);
    if (!same) {
      where = Join(std::move(where), std::move(part));
      continue;
    }
    GraphPattern* last = &where;
    if (last->kind == GraphPattern::Kind::kJoin) last = &last->parts[1];
    if (last->kind == GraphPattern::Kind::kGraph) last = &last->parts[0];
    last->triples.push_back(quad.triple);
  }
  query_.select.where = std::move(where);
  AddTemplateColumns(operation->removed);
}

// [41] Modify
void SparqlGrammar::ReadModify(UpdateOperation* operation) {
  if (TakeWord("WITH")) operation->with = ReadIri();
  const auto labels = block_of_label_;
  const bool deletes = TakeWord("DELETE");
  if (deletes) operation->removed = ReadQuads({true, true, false, "DELETE"});
  if (!deletes || AtWord("INSERT")) {
    ExpectWord("INSERT");
    block_of_label_.clear();
    operation->added = ReadQuads({true, true, true, "INSERT"});
  }
  // Each template has its own scope of blank node labels.
  block_of_label_ = labels;
  block_ = ++blocks_;
  ReadUsing();
  if (!AtWord("WHERE")) Expected("WHERE");
  ReadWhere(&query_.select);
  std::vector<QuadTemplate> all = operation->removed;
  all.insert(all.end(), operation->added.begin(), operation->added.end());
  AddTemplateColumns(all);
}

// [43] UsingClause
void SparqlGrammar::ReadUsing() {
  while (TakeWord("USING")) {
    query_.has_dataset = true;
    const bool named = TakeWord("NAMED");
    (named ? query_.from_named : query_.from).push_back(ReadIri());
  }
}

UpdateRequest ParseUpdate(std::string_view text, int nesting) {
  return SparqlGrammar(Tokenize(text), nesting).ReadUpdate();
}

}  // namespace kg_core::sparql
