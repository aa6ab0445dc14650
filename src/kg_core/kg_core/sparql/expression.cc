#include "kg_core/sparql/expression.h"

#include <chrono>
#include <utility>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/values.h"
#include "kg_core/sparql/xsd_date_time.h"

namespace kg_core::sparql {
namespace {

using Op = Expression::Op;

Term NowLiteral() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
  return Literal(FormatUtc(ms), std::string(kXsd) + "dateTime");
}

const Term& BooleanTerm(bool value) {
  static const Term* const kTrue = new Term(BooleanLiteral(true));
  static const Term* const kFalse = new Term(BooleanLiteral(false));
  return value ? *kTrue : *kFalse;
}

std::optional<bool> Negated(std::optional<bool> truth) {
  if (truth) truth = !*truth;
  return truth;
}

// https://www.w3.org/TR/sparql11-query/#OperatorMapping
std::optional<bool> Relation(Op op, const Term& a, const Term& b) {
  if (op == Op::kEqual) return Equal(a, b);
  if (op == Op::kNotEqual) return Negated(Equal(a, b));
  const std::optional<Order> order = Compare(a, b);
  if (!order) return std::nullopt;
  switch (op) {
    case Op::kLess:
      return *order == Order::kLess;
    case Op::kGreater:
      return *order == Order::kGreater;
    case Op::kLessEqual:
      return *order == Order::kLess || *order == Order::kEqual;
    default:  // kGreaterEqual
      return *order == Order::kGreater || *order == Order::kEqual;
  }
}

Arithmetic ToOperation(Op op) {
  switch (op) {
    case Op::kAdd:
      return Arithmetic::kAdd;
    case Op::kSubtract:
      return Arithmetic::kSubtract;
    case Op::kMultiply:
      return Arithmetic::kMultiply;
    default:  // kDivide
      return Arithmetic::kDivide;
  }
}

}  // namespace

ExpressionEvaluator::ExpressionEvaluator(const Query* query, TermTable* terms,
                                         QueryBudget* budget, Exists exists)
    : query_(query),
      terms_(terms),
      budget_(budget),
      exists_(std::move(exists)) {
  context_.base = query->base;
  context_.now = NowLiteral();
  context_.random.seed(std::random_device{}());
}

const Term* ExpressionEvaluator::Own(Term term) {
  computed_.push_back(std::move(term));
  return &computed_.back();
}

const Term* ExpressionEvaluator::Own(std::optional<bool> truth) {
  return truth ? &BooleanTerm(*truth) : nullptr;
}

bool ExpressionEvaluator::Holds(const Expression& expression,
                                const Solution& solution) {
  const std::size_t mark = computed_.size();
  const bool holds = Truth(expression, solution).value_or(false);
  computed_.resize(mark);
  return holds;
}

TermId ExpressionEvaluator::Evaluate(const Expression& expression,
                                     const Solution& solution) {
  if (expression.op == Op::kVariable) {
    return solution.row[static_cast<std::size_t>(expression.index)];
  }
  const std::size_t mark = computed_.size();
  const Term* value = Value(expression, solution);
  const TermId id = value == nullptr ? kNoTerm : terms_->Intern(*value);
  computed_.resize(mark);
  return id;
}

const Term* ExpressionEvaluator::Variable(int variable,
                                          const Solution& solution) const {
  const TermId id = solution.row[static_cast<std::size_t>(variable)];
  return id == kNoTerm ? nullptr : &terms_->Get(id);
}

std::optional<bool> ExpressionEvaluator::Truth(const Expression& e,
                                               const Solution& solution) {
  const Term* value = Value(e, solution);
  if (value == nullptr) return std::nullopt;
  return EffectiveBoolean(*value);
}

const Term* ExpressionEvaluator::Value(const Expression& e,
                                       const Solution& solution) {
  budget_->Step();
  switch (e.op) {
    case Op::kVariable:
      return Variable(e.index, solution);
    case Op::kConstant:
      return &query_->constants[static_cast<std::size_t>(e.index)];
    case Op::kOr:
    case Op::kAnd:
      return Logical(e, solution);
    case Op::kNot:
      return Own(Negated(Truth(e.arguments[0], solution)));
    case Op::kEqual:
    case Op::kNotEqual:
    case Op::kLess:
    case Op::kGreater:
    case Op::kLessEqual:
    case Op::kGreaterEqual:
      return Comparison(e, solution);
    case Op::kIn:
    case Op::kNotIn:
      return Membership(e, solution);
    case Op::kAdd:
    case Op::kSubtract:
    case Op::kMultiply:
    case Op::kDivide:
      return Arithmetic(e, solution);
    case Op::kNegate:
    case Op::kPlus:
      return Sign(e, solution);
    case Op::kCall:
      return Call(e, solution);
    case Op::kBound:
    case Op::kIf:
    case Op::kCoalesce:
    case Op::kSameTerm:
    case Op::kExists:
    case Op::kNotExists:
      return Form(e, solution);
  }
  return nullptr;
}

// An error in one argument matters only if the other arguments do not decide
// the result.
const Term* ExpressionEvaluator::Logical(const Expression& e,
                                         const Solution& solution) {
  const bool decisive = e.op == Op::kOr;
  bool error = false;
  for (const Expression& argument : e.arguments) {
    const std::optional<bool> truth = Truth(argument, solution);
    if (truth && *truth == decisive) return &BooleanTerm(decisive);
    if (!truth) error = true;
  }
  return error ? nullptr : &BooleanTerm(!decisive);
}

const Term* ExpressionEvaluator::Comparison(const Expression& e,
                                            const Solution& solution) {
  const Term* a = Value(e.arguments[0], solution);
  const Term* b = Value(e.arguments[1], solution);
  if (a == nullptr || b == nullptr) return nullptr;
  return Own(Relation(e.op, *a, *b));
}

// https://www.w3.org/TR/sparql11-query/#func-in
const Term* ExpressionEvaluator::Membership(const Expression& e,
                                            const Solution& solution) {
  const bool found = e.op == Op::kIn;
  const Term* value = Value(e.arguments[0], solution);
  if (value == nullptr) return nullptr;
  bool error = false;
  for (std::size_t i = 1; i < e.arguments.size(); ++i) {
    const Term* other = Value(e.arguments[i], solution);
    const std::optional<bool> equal =
        other == nullptr ? std::nullopt : Equal(*value, *other);
    if (equal.value_or(false)) return &BooleanTerm(found);
    if (!equal) error = true;
  }
  return error ? nullptr : &BooleanTerm(!found);
}

const Term* ExpressionEvaluator::Arithmetic(const Expression& e,
                                            const Solution& solution) {
  const Term* a = Value(e.arguments[0], solution);
  const Term* b = Value(e.arguments[1], solution);
  if (a == nullptr || b == nullptr) return nullptr;
  const std::optional<XsdNumber> x = ToNumber(*a);
  const std::optional<XsdNumber> y = ToNumber(*b);
  if (!x || !y) return nullptr;
  const std::optional<XsdNumber> result = Calculate(ToOperation(e.op), *x, *y);
  return result ? Own(ToTerm(*result)) : nullptr;
}

const Term* ExpressionEvaluator::Sign(const Expression& e,
                                      const Solution& solution) {
  const Term* value = Value(e.arguments[0], solution);
  if (value == nullptr) return nullptr;
  std::optional<XsdNumber> number = ToNumber(*value);
  if (!number) return nullptr;
  if (e.op == Op::kPlus) return value;
  number->exact.digits = -number->exact.digits;
  number->real = -number->real;
  return Own(ToTerm(*number));
}

const Term* ExpressionEvaluator::Call(const Expression& e,
                                      const Solution& solution) {
  Arguments arguments;
  arguments.reserve(e.arguments.size());
  for (const Expression& argument : e.arguments) {
    arguments.push_back(Value(argument, solution));
    if (arguments.back() == nullptr) return nullptr;
  }
  Answer answer = e.function->call(context_, arguments);
  return answer ? Own(*std::move(answer)) : nullptr;
}

// https://www.w3.org/TR/sparql11-query/#func-forms
const Term* ExpressionEvaluator::Form(const Expression& e,
                                      const Solution& solution) {
  switch (e.op) {
    case Op::kBound:
      return &BooleanTerm(Variable(e.index, solution) != nullptr);
    case Op::kIf: {
      const std::optional<bool> truth = Truth(e.arguments[0], solution);
      if (!truth) return nullptr;
      return Value(e.arguments[*truth ? 1 : 2], solution);
    }
    case Op::kCoalesce:
      for (const Expression& argument : e.arguments) {
        const Term* value = Value(argument, solution);
        if (value != nullptr) return value;
      }
      return nullptr;
    case Op::kSameTerm: {
      const Term* a = Value(e.arguments[0], solution);
      const Term* b = Value(e.arguments[1], solution);
      if (a == nullptr || b == nullptr) return nullptr;
      return &BooleanTerm(*a == *b);
    }
    default:  // kExists, kNotExists
      return &BooleanTerm(exists_(*e.pattern, solution) ==
                          (e.op == Op::kExists));
  }
}

}  // namespace kg_core::sparql
