// Why a number is what it is: contributions that sum to it, each with the facts
// it comes from.
//
//   value = sum of parts' values, within 1e-9
//
// What an equation does beside summing (a clamp, a mask, the normalisation) is
// a contribution of its own: the change it makes at its place in the equation.
// So nothing is hidden in a remainder.

#ifndef KG_COMPILER_EXPLAIN_EXPLANATION_H_
#define KG_COMPILER_EXPLAIN_EXPLANATION_H_

#include <string>
#include <vector>

namespace kg_compiler {

struct Contribution {
  double value = 0.0;  // In the explanation's unit.
  std::string term;    // Of the equation: "gamma_front * F'".
  // Facts of the world that it comes from, as Turtle triples with their current
  // values: "ex:fast ex:gamma_front 0.6".
  std::vector<std::string> facts;
  std::string text;  // For a person, one line.
};

struct Explanation {
  double value = 0.0;
  std::string unit;     // "1", "reward", "m", "s", "J", "agents".
  std::string verdict;  // Of a why-not: "worth_less", "forbidden", ...
  std::vector<Contribution> parts;
  std::string text;  // For a person: what the value is of, and what follows.

  double Sum() const;
  // Adds a part unless its value is 0.
  void AddIfAny(Contribution part);
};

// A number for a person: four digits.
std::string Short(double value);
std::string Signed(double value);  // "+0.53", "-0.1".

// The headline, a line a contribution, and under each its facts.
std::string ToText(const Explanation& explanation);
// {"value", "unit", "verdict", "text", "contributions": [{"value", "term",
// "text", "facts": [...]}]}; numbers read back exactly, NaN as null.
std::string ToJson(const Explanation& explanation);

// The facts of a contribution as one Turtle text: triples separated by " . ".
std::string JoinFacts(const std::vector<std::string>& facts);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLANATION_H_
