// Group graph patterns, rules [53] to [69]; the algebra is built on the way:
// https://www.w3.org/TR/sparql11-query/#sparqlTranslateGraphPatterns

#include "kg_core/sparql/grammar.h"

namespace kg_core::sparql {
namespace {

// What an evaluation's recursion is deep at most; see CountPattern.
constexpr int kMaxPatterns = 1000;

Pattern Binary(Pattern::Kind kind, Pattern left, Pattern right) {
  Pattern pattern;
  pattern.kind = kind;
  pattern.parts.push_back(std::move(left));
  pattern.parts.push_back(std::move(right));
  return pattern;
}

bool IsUnit(const Pattern& pattern) {
  return pattern.kind == Pattern::Kind::kBasic && pattern.triples.empty();
}

}  // namespace

void Grammar::CountPattern() {
  if (++patterns_ > kMaxPatterns) {
    Fail(Peek(),
         "more patterns than the limit of " + std::to_string(kMaxPatterns));
  }
}

Pattern Grammar::Join(Pattern left, Pattern right) {
  if (IsUnit(left)) return right;
  if (IsUnit(right)) return left;
  return Binary(Pattern::Kind::kJoin, std::move(left), std::move(right));
}

// [53] GroupGraphPattern
Grammar::Group Grammar::ReadGroup() {
  const Nested nested(this);
  CountPattern();
  ExpectMark("{");
  Group group;
  if (AtWord("SELECT")) {
    group.pattern.kind = Pattern::Kind::kSelect;
    group.pattern.select = std::make_unique<Select>();
    Select* const outer = aggregates_of_;
    block_ = ++blocks_;
    ReadSelect(group.pattern.select.get());
    block_ = ++blocks_;
    aggregates_of_ = outer;
    ExpectMark("}");
    return group;
  }
  block_ = ++blocks_;
  Pattern basic;
  while (!TakeMark("}")) ReadGroupElement(&group, &basic);
  group.pattern = Join(std::move(group.pattern), std::move(basic));
  block_ = ++blocks_;
  return group;
}

Pattern Grammar::ReadGroupPattern() {
  Group group = ReadGroup();
  if (group.filters.empty()) return std::move(group.pattern);
  Pattern filter;
  filter.kind = Pattern::Kind::kFilter;
  filter.parts.push_back(std::move(group.pattern));
  filter.filters = std::move(group.filters);
  return filter;
}

// [54] GroupGraphPatternSub, [56] GraphPatternNotTriples
void Grammar::ReadGroupElement(Group* group, Pattern* basic) {
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
  *basic = Pattern();
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
Pattern Grammar::ReadOptional(Pattern left) {
  Group right = ReadGroup();
  Pattern pattern = Binary(Pattern::Kind::kLeftJoin, std::move(left),
                           std::move(right.pattern));
  pattern.filters = std::move(right.filters);
  return pattern;
}

// [66] MinusGraphPattern
Pattern Grammar::ReadMinus(Pattern left) {
  return Binary(Pattern::Kind::kMinus, std::move(left), ReadGroupPattern());
}

// [58] GraphGraphPattern
Pattern Grammar::ReadGraph() {
  Pattern pattern;
  pattern.kind = Pattern::Kind::kGraph;
  if (Peek().kind == Token::Kind::kVariable) {
    pattern.graph = {true, ReadVariable()};
  } else {
    pattern.graph = ConstantNode(Iri(ReadIri()));
  }
  pattern.parts.push_back(ReadGroupPattern());
  return pattern;
}

// [59] ServiceGraphPattern: this store asks nobody. SERVICE fails then, and
// with SILENT it has one solution that binds nothing: OPTIONAL of what never
// is. https://www.w3.org/TR/sparql11-federated-query/#serviceSilent
Pattern Grammar::ReadService() {
  const Position position = Take().position;
  const bool silent = TakeWord("SILENT");
  const std::string before = query_.unavailable;
  if (Peek().kind == Token::Kind::kVariable) {
    ReadVariable();
  } else {
    ReadIri();
  }
  const Pattern inner = ReadGroupPattern();
  query_.unavailable = before;
  if (!silent && before.empty()) {
    query_.unavailable = std::to_string(position.line) + ":" +
                         std::to_string(position.column) +
                         ": SERVICE is not available: a query reads this store "
                         "only";
  }
  Pattern nothing;
  nothing.kind = Pattern::Kind::kValues;
  nothing.variables = VisibleVariables(inner).Members();
  return Binary(Pattern::Kind::kLeftJoin, Pattern(), std::move(nothing));
}

// [67] GroupOrUnionGraphPattern
Pattern Grammar::ReadGroupOrUnion() {
  Pattern first = ReadGroupPattern();
  if (!AtWord("UNION")) return first;
  Pattern pattern;
  pattern.kind = Pattern::Kind::kUnion;
  pattern.parts.push_back(std::move(first));
  while (TakeWord("UNION")) pattern.parts.push_back(ReadGroupPattern());
  return pattern;
}

// [60] Bind
void Grammar::ReadBind(Group* group) {
  ExpectMark("(");
  Pattern pattern;
  pattern.kind = Pattern::Kind::kExtend;
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
Pattern Grammar::ReadValues() {
  Pattern pattern;
  pattern.kind = Pattern::Kind::kValues;
  const bool single = Peek().kind == Token::Kind::kVariable;
  if (single) {
    pattern.variables.push_back(ReadVariable());
  } else {
    ExpectMark("(");
    while (!TakeMark(")")) pattern.variables.push_back(ReadVariable());
  }
  ExpectMark("{");
  while (!TakeMark("}")) {
    pattern.rows.push_back(single ? std::vector<int>{ReadDataValue()}
                                  : ReadValuesRow(pattern.variables.size()));
  }
  return pattern;
}

std::vector<int> Grammar::ReadValuesRow(std::size_t width) {
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
int Grammar::ReadDataValue() {
  if (TakeWord("UNDEF")) return kNone;
  if (AtIri()) return ConstantNumber(Iri(ReadIri()));
  if (AtLiteral()) return ConstantNumber(ReadLiteral());
  Expected("an IRI, a literal or UNDEF");
}

}  // namespace kg_core::sparql
