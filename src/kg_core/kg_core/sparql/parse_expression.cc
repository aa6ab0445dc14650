// Expressions, rules [110] to [128].

#include <algorithm>
#include <cctype>

#include "kg_core/sparql/grammar.h"

namespace kg_core::sparql {
namespace {

using Op = Expression::Op;

// Maximum number of chained operators of one precedence.
constexpr int kMaxChain = 1000;

struct MarkOp {
  std::string_view mark;
  Op op;
};
// [114] RelationalExpression
constexpr MarkOp kRelations[] = {
    {"=", Op::kEqual},   {"!=", Op::kNotEqual},  {"<", Op::kLess},
    {">", Op::kGreater}, {"<=", Op::kLessEqual}, {">=", Op::kGreaterEqual}};
constexpr MarkOp kSums[] = {{"+", Op::kAdd}, {"-", Op::kSubtract}};
constexpr MarkOp kProducts[] = {{"*", Op::kMultiply}, {"/", Op::kDivide}};
constexpr MarkOp kUnaries[] = {
    {"!", Op::kNot}, {"-", Op::kNegate}, {"+", Op::kPlus}};

// [121] BuiltInCall: forms that are not plain functions.
struct SpecialForm {
  const char* word;
  Op op;
  std::size_t least;
  std::size_t most;
};
constexpr SpecialForm kSpecialForms[] = {
    {"IF", Op::kIf, 3, 3},
    {"COALESCE", Op::kCoalesce, 0, kAnyNumber},
    {"SAMETERM", Op::kSameTerm, 2, 2},
};

// [127] Aggregate
struct AggregateWord {
  const char* word;
  AggregateCall::Kind kind;
};
constexpr AggregateWord kAggregates[] = {
    {"COUNT", AggregateCall::Kind::kCount},
    {"SUM", AggregateCall::Kind::kSum},
    {"AVG", AggregateCall::Kind::kAvg},
    {"MIN", AggregateCall::Kind::kMin},
    {"MAX", AggregateCall::Kind::kMax},
    {"SAMPLE", AggregateCall::Kind::kSample},
    {"GROUP_CONCAT", AggregateCall::Kind::kGroupConcat},
};

Expression Of(Op op, std::vector<Expression> arguments) {
  Expression expression;
  expression.op = op;
  expression.arguments = std::move(arguments);
  return expression;
}

Expression Of(Op op, Expression first, Expression second) {
  std::vector<Expression> arguments;
  arguments.push_back(std::move(first));
  arguments.push_back(std::move(second));
  return Of(op, std::move(arguments));
}

Expression Of(Op op, int index) {
  Expression expression;
  expression.op = op;
  expression.index = index;
  return expression;
}

std::string Upper(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace

// [111] ConditionalOrExpression
Expression SparqlGrammar::ReadExpression() {
  const Nested nested(this);
  std::vector<Expression> parts;
  do {
    parts.push_back(ReadAnd());
  } while (TakeMark("||"));
  return parts.size() == 1 ? std::move(parts[0])
                           : Of(Op::kOr, std::move(parts));
}

// [112] ConditionalAndExpression
Expression SparqlGrammar::ReadAnd() {
  std::vector<Expression> parts;
  do {
    parts.push_back(ReadRelational());
  } while (TakeMark("&&"));
  return parts.size() == 1 ? std::move(parts[0])
                           : Of(Op::kAnd, std::move(parts));
}

// [114] RelationalExpression
Expression SparqlGrammar::ReadRelational() {
  Expression left = ReadAdditive();
  for (const MarkOp& relation : kRelations) {
    if (!TakeMark(relation.mark)) continue;
    return Of(relation.op, std::move(left), ReadAdditive());
  }
  const bool negated = AtWord("NOT") && AtWord("IN", 1);
  if (!negated && !AtWord("IN")) return left;
  Take();
  if (negated) Take();
  std::vector<Expression> arguments = ReadArguments();
  arguments.insert(arguments.begin(), std::move(left));
  return Of(negated ? Op::kNotIn : Op::kIn, std::move(arguments));
}

// [116] AdditiveExpression
Expression SparqlGrammar::ReadAdditive() {
  Expression left = ReadMultiplicative();
  for (int chain = 0;; ++chain) {
    const auto* sum =
        std::find_if(std::begin(kSums), std::end(kSums),
                     [this](const MarkOp& op) { return AtMark(op.mark); });
    if (sum == std::end(kSums)) return left;
    if (chain >= kMaxChain) Fail(Peek(), "this sum is too long");
    Take();
    left = Of(sum->op, std::move(left), ReadMultiplicative());
  }
}

// [117] MultiplicativeExpression
Expression SparqlGrammar::ReadMultiplicative() {
  Expression left = ReadUnary();
  for (int chain = 0;; ++chain) {
    const auto* product =
        std::find_if(std::begin(kProducts), std::end(kProducts),
                     [this](const MarkOp& op) { return AtMark(op.mark); });
    if (product == std::end(kProducts)) return left;
    if (chain >= kMaxChain) Fail(Peek(), "this product is too long");
    Take();
    left = Of(product->op, std::move(left), ReadUnary());
  }
}

// [118] UnaryExpression
Expression SparqlGrammar::ReadUnary() {
  if (AtLiteral()) return ReadPrimary();
  for (const MarkOp& unary : kUnaries) {
    if (!TakeMark(unary.mark)) continue;
    const Nested nested(this);
    std::vector<Expression> argument;
    argument.push_back(ReadPrimary());
    return Of(unary.op, std::move(argument));
  }
  return ReadPrimary();
}

// [120] BrackettedExpression
Expression SparqlGrammar::ReadBracketed() {
  ExpectMark("(");
  Expression expression = ReadExpression();
  ExpectMark(")");
  return expression;
}

// [119] PrimaryExpression
Expression SparqlGrammar::ReadPrimary() {
  if (AtMark("(")) return ReadBracketed();
  if (Peek().kind == Token::Kind::kVariable) {
    return Of(Op::kVariable, ReadVariable());
  }
  if (AtLiteral()) return Of(Op::kConstant, ConstantNumber(ReadLiteral()));
  if (AtIri()) return ReadIriExpression();
  if (Peek().kind == Token::Kind::kWord) return ReadWordExpression();
  if (AtMark("!")) return ReadUnary();
  Expected("an expression");
}

// [69] Constraint
Expression SparqlGrammar::ReadConstraint() {
  if (AtMark("(")) return ReadBracketed();
  if (AtIri()) {
    const Token name = Peek();
    Expression call = ReadIriExpression();
    if (call.op != Op::kCall) Fail(name, "expected a condition");
    return call;
  }
  if (Peek().kind != Token::Kind::kWord || AtLiteral()) {
    Expected("a condition: '(' or a function");
  }
  return ReadWordExpression();
}

// [128] iriOrFunction
Expression SparqlGrammar::ReadIriExpression() {
  const QueryPosition position = Peek().position;
  const std::string iri = ReadIri();
  if (!AtMark("(")) return Of(Op::kConstant, ConstantNumber(Iri(iri)));
  const SparqlFunction* function = FindIriFunction(iri);
  if (function != nullptr) return ReadCall(*function, position);
  if (query_.unavailable.empty()) {
    query_.unavailable = std::to_string(position.line) + ":" +
                         std::to_string(position.column) + ": function <" +
                         iri + "> is not known";
  }
  return Of(Op::kCall, ReadArguments());
}

// [71] ArgList, [79] ExpressionList
std::vector<Expression> SparqlGrammar::ReadArguments() {
  std::vector<Expression> arguments;
  ExpectMark("(");
  if (TakeMark(")")) return arguments;
  do {
    arguments.push_back(ReadExpression());
  } while (TakeMark(","));
  ExpectMark(")");
  return arguments;
}

Expression SparqlGrammar::ReadCall(const SparqlFunction& function,
                                   QueryPosition position) {
  Expression call = Of(Op::kCall, ReadArguments());
  call.function = &function;
  const std::size_t count = call.arguments.size();
  if (count < function.least || count > function.most) {
    FailAt(position, function.name + " takes " +
                         std::to_string(function.least) +
                         (function.most == function.least ? "" : " or more") +
                         " arguments, got " + std::to_string(count));
  }
  return call;
}

// [121] BuiltInCall
Expression SparqlGrammar::ReadWordExpression() {
  const Token word = Peek();
  const std::string name = Upper(word.text);
  for (const SpecialForm& form : kSpecialForms) {
    if (name != form.word) continue;
    return ReadSpecialForm(form.op, form.least, form.most);
  }
  for (const AggregateWord& aggregate : kAggregates) {
    if (name == aggregate.word) return ReadAggregate(aggregate.kind);
  }
  if (name == "BOUND") {
    Take();
    ExpectMark("(");
    const int variable = ReadVariable();
    ExpectMark(")");
    return Of(Op::kBound, variable);
  }
  if (name == "EXISTS") return ReadExists(Op::kExists);
  if (name == "NOT" && AtWord("EXISTS", 1)) {
    Take();
    return ReadExists(Op::kNotExists);
  }
  // All other words must be plain functions.
  const SparqlFunction* function = FindKeywordFunction(name);
  if (function == nullptr) {
    Fail(word, "expected an expression, got " + word.text);
  }
  Take();
  return ReadCall(*function, word.position);
}

Expression SparqlGrammar::ReadSpecialForm(Op op, std::size_t least,
                                          std::size_t most) {
  const Token word = Take();
  Expression form = Of(op, ReadArguments());
  const std::size_t count = form.arguments.size();
  if (count < least || count > most) {
    Fail(word, Upper(word.text) + " takes " + std::to_string(least) +
                   (most == least ? "" : " or more") + " arguments, got " +
                   std::to_string(count));
  }
  return form;
}

// [125] ExistsFunc, [126] NotExistsFunc
Expression SparqlGrammar::ReadExists(Op op) {
  ExpectWord("EXISTS");
  SelectQuery* const outer = aggregates_of_;
  aggregates_of_ = nullptr;
  Expression expression;
  expression.op = op;
  expression.pattern = std::make_unique<GraphPattern>(ReadGroupPattern());
  aggregates_of_ = outer;
  return expression;
}

// [127] Aggregate: its value becomes a variable of the group.
Expression SparqlGrammar::ReadAggregate(AggregateCall::Kind kind) {
  const Token word = Take();
  if (aggregates_of_ == nullptr) {
    Fail(word, word.text +
                   " may stand in SELECT, HAVING and ORDER BY only, "
                   "and not within another aggregate");
  }
  // Aggregates cannot be nested.
  SelectQuery* const select = aggregates_of_;
  aggregates_of_ = nullptr;
  AggregateCall aggregate;
  aggregate.kind = kind;
  ExpectMark("(");
  aggregate.distinct = TakeWord("DISTINCT");
  if (kind != AggregateCall::Kind::kCount || !TakeMark("*")) {
    aggregate.argument = ReadExpression();
  }
  if (kind == AggregateCall::Kind::kGroupConcat) ReadSeparator(&aggregate);
  ExpectMark(")");
  aggregate.variable = FreshVariable();
  const int variable = aggregate.variable;
  aggregates_of_ = select;
  select->aggregates.push_back(std::move(aggregate));
  return Of(Op::kVariable, variable);
}

void SparqlGrammar::ReadSeparator(AggregateCall* aggregate) {
  if (!TakeMark(";")) return;
  ExpectWord("SEPARATOR");
  ExpectMark("=");
  if (Peek().kind != Token::Kind::kString) Expected("a string");
  aggregate->separator = Take().text;
}

}  // namespace kg_core::sparql
