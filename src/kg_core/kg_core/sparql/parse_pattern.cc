// Group graph patterns, rules [53] to [69]; the algebra is built on the way:
// https://www.w3.org/TR/sparql11-query/#sparqlTranslateGraphPatterns

#include <algorithm>

#include "kg_core/sparql/grammar.h"

namespace kg_core::sparql {
namespace {

// Limit on the number of patterns, which bounds the recursion depth of the
// evaluation; see CountPattern.
constexpr int kMaxPatterns = 1000;

GraphPattern Binary(GraphPattern::Kind kind, GraphPattern left,
                    GraphPattern right) {
  GraphPattern pattern;
  pattern.kind = kind;
  pattern.parts.push_back(std::move(left));
  pattern.parts.push_back(std::move(right));
  return pattern;
}

bool IsUnit(const GraphPattern& pattern) {
  return pattern.kind == GraphPattern::Kind::kBasic && pattern.triples.empty();
}

}  // namespace

void SparqlGrammar::CountPattern() {
  if (++patterns_ > kMaxPatterns) {
    Fail(Peek(),
         "more patterns than the limit of " + std::to_string(kMaxPatterns));
  }
}

GraphPattern SparqlGrammar::Join(GraphPattern left, GraphPattern right) {
  if (IsUnit(left)) return right;
  if (IsUnit(right)) return left;
  return Binary(GraphPattern::Kind::kJoin, std::move(left), std::move(right));
}

// [53] GroupGraphPattern
SparqlGrammar::Group SparqlGrammar::ReadGroup() {
  const Nested nested(this);
  CountPattern();
  ExpectMark("{");
  Group group;
  if (AtWord("SELECT")) {
    group.pattern.kind = GraphPattern::Kind::kSelect;
    group.pattern.select = std::make_unique<SelectQuery>();
    SelectQuery* const outer = aggregates_of_;
    block_ = ++blocks_;
    ReadSelect(group.pattern.select.get());
    block_ = ++blocks_;
    aggregates_of_ = outer;
    ExpectMark("}");
    return group;
  }
  // A blank node label must not be used in two basic graph patterns, so each
  // pattern gets its own block number.
  block_ = ++blocks_;
  GraphPattern basic;
  while (!TakeMark("}")) ReadGroupElement(&group, &basic);
  group.pattern = Join(std::move(group.pattern), std::move(basic));
  block_ = ++blocks_;
  return group;
}

GraphPattern SparqlGrammar::ReadGroupPattern() {
  Group group = ReadGroup();
  if (group.filters.empty()) return std::move(group.pattern);
  GraphPattern filter;
  filter.kind = GraphPattern::Kind::kFilter;
  filter.parts.push_back(std::move(group.pattern));
  filter.filters = std::move(group.filters);
  return filter;
}

// [54] GroupGraphPatternSub, [56] GraphPatternNotTriples
void SparqlGrammar::ReadGroupElement(Group* group, GraphPattern* basic) {
  if (AtTriples()) {
    ReadTriplesBlock(basic);
    if (AtTriples()) Expected("'.' or '}'");
    return;
  }
  if (TakeWord("FILTER")) {
    // [68] Filter: does not end a basic graph pattern.
    const int block = block_;
    group->filters.push_back(ReadConstraint());
    block_ = block;
    TakeMark(".");
    return;
  }
  CountPattern();
  group->pattern = Join(std::move(group->pattern), std::move(*basic));
  *basic = GraphPattern();
  if (TakeWord("OPTIONAL")) {
    group->pattern = ReadOptional(std::move(group->pattern));
  } else if (TakeWord("MINUS")) {
    group->pattern = ReadMinus(std::move(group->pattern));
  } else if (TakeWord("BIND")) {
    ReadBind(group);
  } else if (TakeWord("GRAPH")) {
    group->pattern = Join(std::move(group->pattern), ReadGraph());
  } else if (TakeWord("VALUES")) {
    group->pattern = Join(std::move(group->pattern), ReadValues());
  } else if (AtMark("{")) {
    group->pattern = Join(std::move(group->pattern), ReadGroupOrUnion());
  } else if (AtWord("SERVICE")) {
    group->pattern = Join(std::move(group->pattern), ReadService());
  } else {
    Expected("a graph pattern or '}'");
  }
  block_ = ++blocks_;
  TakeMark(".");
}

// [57] OptionalGraphPattern: the filters of its group see the left side.
GraphPattern SparqlGrammar::ReadOptional(GraphPattern left) {
  Group right = ReadGroup();
  GraphPattern pattern = Binary(GraphPattern::Kind::kLeftJoin, std::move(left),
                                std::move(right.pattern));
  pattern.filters = std::move(right.filters);
  return pattern;
}

// [66] MinusGraphPattern
GraphPattern SparqlGrammar::ReadMinus(GraphPattern left) {
  return Binary(GraphPattern::Kind::kMinus, std::move(left),
                ReadGroupPattern());
}

// [58] GraphGraphPattern
GraphPattern SparqlGrammar::ReadGraph() {
  GraphPattern pattern;
  pattern.kind = GraphPattern::Kind::kGraph;
  if (Peek().kind == Token::Kind::kVariable) {
    pattern.graph = {true, ReadVariable()};
  } else {
    pattern.graph = ConstantNode(Iri(ReadIri()));
  }
  pattern.parts.push_back(ReadGroupPattern());
  return pattern;
}

// [59] ServiceGraphPattern: this store never contacts other endpoints, so
// SERVICE fails. With SILENT it has one solution without bindings, expressed as
// OPTIONAL with a pattern that never matches.
// https://www.w3.org/TR/sparql11-federated-query/#serviceSilent
GraphPattern SparqlGrammar::ReadService() {
  const QueryPosition position = Take().position;
  const bool silent = TakeWord("SILENT");
  const std::string before = query_.unavailable;
  if (Peek().kind == Token::Kind::kVariable) {
    ReadVariable();
  } else {
    ReadIri();
  }
  const GraphPattern inner = ReadGroupPattern();
  query_.unavailable = before;
  if (!silent && before.empty()) {
    query_.unavailable = std::to_string(position.line) + ":" +
                         std::to_string(position.column) +
                         ": SERVICE is not available: a query reads this store "
                         "only";
  }
  // The variables of a failed SERVICE SILENT stay visible, but unbound.
  GraphPattern nothing;
  nothing.kind = GraphPattern::Kind::kValues;
  nothing.variables = VisibleVariables(inner).Members();
  return Binary(GraphPattern::Kind::kLeftJoin, GraphPattern(),
                std::move(nothing));
}

// [67] GroupOrUnionGraphPattern
GraphPattern SparqlGrammar::ReadGroupOrUnion() {
  GraphPattern first = ReadGroupPattern();
  if (!AtWord("UNION")) return first;
  GraphPattern pattern;
  pattern.kind = GraphPattern::Kind::kUnion;
  pattern.parts.push_back(std::move(first));
  while (TakeWord("UNION")) pattern.parts.push_back(ReadGroupPattern());
  return pattern;
}

// [60] Bind
void SparqlGrammar::ReadBind(Group* group) {
  ExpectMark("(");
  GraphPattern pattern;
  pattern.kind = GraphPattern::Kind::kExtend;
  pattern.filters.push_back(ReadExpression());
  ExpectWord("AS");
  const Token name = Peek();
  pattern.variable = ReadVariable();
  ExpectMark(")");
  if (VisibleVariables(group->pattern).Contains(pattern.variable)) {
    Fail(name, "?" + name.text + " already has values in this group");
  }
  pattern.parts.push_back(std::move(group->pattern));
  group->pattern = std::move(pattern);
}

// [61] InlineData, [62] DataBlock
GraphPattern SparqlGrammar::ReadValues() {
  GraphPattern pattern;
  pattern.kind = GraphPattern::Kind::kValues;
  const bool single = Peek().kind == Token::Kind::kVariable;
  if (single) {
    pattern.variables.push_back(ReadVariable());
  } else {
    ExpectMark("(");
    while (!TakeMark(")")) {
      pattern.variables.push_back(ReadValuesName(pattern.variables));
    }
  }
  ExpectMark("{");
  while (!TakeMark("}")) {
    pattern.rows.push_back(single ? std::vector<int>{ReadDataValue()}
                                  : ReadValuesRow(pattern.variables.size()));
  }
  return pattern;
}

int SparqlGrammar::ReadValuesName(const std::vector<int>& known) {
  const Token name = Peek();
  const int variable = ReadVariable();
  if (std::find(known.begin(), known.end(), variable) != known.end()) {
    Fail(name, "?" + name.text + " is a column of these values already");
  }
  return variable;
}

std::vector<int> SparqlGrammar::ReadValuesRow(std::size_t width) {
  const Token start = Peek();
  ExpectMark("(");
  std::vector<int> row;
  while (!TakeMark(")")) row.push_back(ReadDataValue());
  if (row.size() != width) {
    Fail(start, "expected " + std::to_string(width) + " values, got " +
                    std::to_string(row.size()));
  }
  return row;
}

// [65] DataBlockValue
int SparqlGrammar::ReadDataValue() {
  if (TakeWord("UNDEF")) return kNone;
  if (AtIri()) return ConstantNumber(Iri(ReadIri()));
  if (AtLiteral()) return ConstantNumber(ReadLiteral());
  Expected("an IRI, a literal or UNDEF");
}

}  // namespace kg_core::sparql
