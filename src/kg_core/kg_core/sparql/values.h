// Values of literals: numbers, boolean value, equality and order.
// https://www.w3.org/TR/sparql11-query/#operandDataTypes
//
// std::nullopt stands for SPARQL's type error throughout.

#ifndef KG_CORE_SPARQL_VALUES_H_
#define KG_CORE_SPARQL_VALUES_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_base/text/decimal.h"
#include "kg_core/rdf/term.h"

namespace kg_core::sparql {

// A numeric value; types in the order of promotion.
// https://www.w3.org/TR/xpath20/#promotion
struct XsdNumber {
  enum class Type { kInteger, kDecimal, kFloat, kDouble };
  Type type = Type::kInteger;
  kg_base::Decimal exact;  // Value of integers and decimals.
  double real = 0;         // Value of floats and doubles.

  bool is_exact() const { return type <= Type::kDecimal; }
  double ToDouble() const {
    return is_exact() ? kg_base::ToDouble(exact) : real;
  }
};

enum class Arithmetic { kAdd, kSubtract, kMultiply, kDivide };

bool IsNumericType(const std::string& datatype);
// nullopt unless the lexical form is valid and in the range of the datatype.
std::optional<XsdNumber> ToNumber(const Term& term);
Term ToTerm(const XsdNumber& number);
std::optional<XsdNumber> Calculate(Arithmetic operation, const XsdNumber& a,
                                   const XsdNumber& b);
// Rounds to an integer, halves up; keeps the sign of zero, NaN and infinities.
// https://www.w3.org/TR/xpath-functions/#func-round
double RoundHalfUp(double value);
// Reads the lexical forms of xsd:double and xsd:float ("1e3", "INF", "NaN").
std::optional<double> ParseDouble(const std::string& text);

bool IsString(const Term& term);  // A literal of xsd:string.
// A literal of xsd:string or with a language.
bool IsStringLike(const Term& term);

// https://www.w3.org/TR/sparql11-query/#ebv
std::optional<bool> EffectiveBoolean(const Term& term);

// The operator '='. https://www.w3.org/TR/sparql11-query/#func-RDFterm-equal
std::optional<bool> Equal(const Term& a, const Term& b);

// The operator '<'; comparisons with NaN give kNone.
// https://www.w3.org/TR/sparql11-query/#OperatorMapping
enum class Order { kLess, kEqual, kGreater, kNone };
std::optional<Order> Compare(const Term& a, const Term& b);

// Order of ORDER BY, MIN and MAX: unbound (nullptr), blank nodes, IRIs,
// literals by value; terms that '<' does not order by type, then text. Numbers
// are compared exactly, so that this is an order where '<' rounds an integer or
// decimal to a double first. Returns -1, 0 or 1.
// https://www.w3.org/TR/sparql11-query/#modOrderBy
int CompareTerms(const Term* a, const Term* b);

// The rank of each of `terms` in the order of CompareTerms, so that sorting
// rows parses each literal once instead of once per comparison. Calls `step`
// during the computation, which may throw.
std::vector<int> ComputeRanks(const std::vector<const Term*>& terms,
                              absl::FunctionRef<void()> step);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_VALUES_H_
