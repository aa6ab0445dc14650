#include "kg_core/sparql/aggregation.h"

#include <utility>

namespace kg_core::sparql {

using AggregateKind = AggregateCall::Kind;

void AggregateAccumulator::AddRow(const Row& row) {
  if (aggregate_->distinct) {
    Row solution;
    for (const int variable : aggregate_->counted) {
      solution.push_back(row[static_cast<std::size_t>(variable)]);
    }
    const std::size_t size = solution.size();
    if (!seen_rows_.insert(std::move(solution)).second) return;
    budget_->UseWorkingBytes(2 * sizeof(TermId) * (size + 8));
  }
  ++count_;
}

// An error invalidates sums and averages; other aggregates skip it.
void AggregateAccumulator::Add(TermId value) {
  if (value == kNoTerm) {
    error_ = true;
    return;
  }
  // DISTINCT: ignore a value that was already counted.
  if (aggregate_->distinct) {
    if (!seen_.insert(value).second) return;
    budget_->UseWorkingBytes(4 * sizeof(TermId));
  }
  ++count_;
  const Term& term = terms_->Get(value);
  switch (aggregate_->kind) {
    case AggregateKind::kCount:
      break;
    case AggregateKind::kSum:
    case AggregateKind::kAvg:
      AddNumber(term);
      break;
    case AggregateKind::kMin:
      if (best_ == kNoTerm || CompareTerms(&term, &terms_->Get(best_)) < 0) {
        best_ = value;
      }
      break;
    case AggregateKind::kMax:
      if (best_ == kNoTerm || CompareTerms(&term, &terms_->Get(best_)) > 0) {
        best_ = value;
      }
      break;
    case AggregateKind::kSample:
      if (best_ == kNoTerm) best_ = value;
      break;
    case AggregateKind::kGroupConcat:
      AddText(term);
      break;
  }
}

void AggregateAccumulator::AddNumber(const Term& term) {
  const std::optional<XsdNumber> number = ToNumber(term);
  if (!number) {
    error_ = true;
    return;
  }
  if (!sum_) sum_ = XsdNumber();
  sum_ = Calculate(Arithmetic::kAdd, *sum_, *number);
  if (!sum_) error_ = true;
}

// The text is STR of each value, which a blank node does not have.
// https://www.w3.org/TR/sparql11-query/#defn_aggGroupConcat
void AggregateAccumulator::AddText(const Term& term) {
  if (term.is_blank()) {
    has_blank_ = true;
    return;
  }
  if (count_ > 1) text_ += aggregate_->separator;
  text_ += term.text;
  budget_->UseWorkingBytes(term.text.size() + aggregate_->separator.size());
}

std::optional<Term> AggregateAccumulator::Result() const {
  const XsdNumber number = sum_.value_or(XsdNumber());
  switch (aggregate_->kind) {
    case AggregateKind::kCount:
      return IntegerLiteral(static_cast<long long>(count_));
    case AggregateKind::kSum:
      if (error_) return std::nullopt;
      return ToTerm(number);
    case AggregateKind::kAvg: {
      if (error_) return std::nullopt;
      // The recommendation defines the average of an empty group as 0.
      if (count_ == 0) return IntegerLiteral(0);
      XsdNumber count;
      count.exact.digits = static_cast<__int128>(count_);
      const std::optional<XsdNumber> average =
          Calculate(Arithmetic::kDivide, number, count);
      if (!average) return std::nullopt;
      return ToTerm(*average);
    }
    case AggregateKind::kMin:
    case AggregateKind::kMax:
    case AggregateKind::kSample:
      if (best_ == kNoTerm) return std::nullopt;
      return terms_->Get(best_);
    case AggregateKind::kGroupConcat:
      if (has_blank_) return std::nullopt;
      return Literal(text_);
  }
  return std::nullopt;
}

}  // namespace kg_core::sparql
