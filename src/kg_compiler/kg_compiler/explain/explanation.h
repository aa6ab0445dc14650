// Explanation of a number: contributions that sum to it, each with the facts it
// is based on.
//
//   value = sum of parts' values, within 1e-9
//
// Every non-additive operation (clamp, mask, normalisation) is a separate
// contribution: the change it makes at its place in the equation. There is no
// unexplained remainder.

#ifndef KG_COMPILER_EXPLAIN_EXPLANATION_H_
#define KG_COMPILER_EXPLAIN_EXPLANATION_H_

#include <string>
#include <vector>

namespace kg_compiler {

struct Contribution {
  double value = 0.0;  // In the explanation's unit.
  std::string term;    // Term of the equation: "gamma_front * F'".
  // Facts it is based on, as Turtle triples with their current values: "ex:fast
  // ex:gamma_front 0.6".
  std::vector<std::string> facts;
  std::string text;  // Human-readable, one line.
};

struct Explanation {
  double value = 0.0;
  std::string unit;     // "1", "reward", "m", "s", "J", "agents".
  std::string verdict;  // Why-not queries: "worth_less", "forbidden", ...
  std::vector<Contribution> parts;
  std::string text;  // Human-readable headline: subject and consequence.

  double Sum() const;
  // Adds a part unless its value is 0.
  void AddIfAny(Contribution part);
};

// Human-readable number with four significant digits.
std::string Short(double value);
std::string Signed(double value);  // "+0.53", "-0.1".

// The headline, one line per contribution, and its facts below it.
std::string ToText(const Explanation& explanation);
// {"value", "unit", "verdict", "text", "contributions": [{"value", "term",
// "text", "facts": [...]}]}; numbers read back exactly, NaN as null.
std::string ToJson(const Explanation& explanation);

// The facts of a contribution as one Turtle text: triples separated by " . ".
std::string JoinFacts(const std::vector<std::string>& facts);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLANATION_H_
