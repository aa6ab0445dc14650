// What a path is worth, term by term: what its score sums, and by what the
// scores of two paths differ.
//
//   score = sum over windows of  value + events - time - energy - risk
//           - uncertainty - churn, and with soft separation - separation
//           (window -1)

#ifndef KG_SELECTOR_EXPLAIN_PATH_TERMS_H_
#define KG_SELECTOR_EXPLAIN_PATH_TERMS_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/explain/explanation.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_selector/explain/planned_world.h"

namespace kg_selector {

enum class TermKind {
  kValue,  // The scores of the waypoints visited.
  kEvents,
  kTime,
  kEnergy,
  kRisk,
  kUncertainty,
  kChurn,  // For leaving the plan in force.
  kSeparation,
  kField  // For what is met under way: wave height, ...
};
const char* Name(TermKind kind);  // "value", "events", ...

struct PathTerm {
  int window = -1;
  TermKind kind = TermKind::kValue;
  double value = 0.0;  // Costs are negative.
  // For a person: the waypoints, the events' names, or the field quantity.
  std::string where;
  std::vector<std::string> events = {};  // kEvents: the IRIs of those earned.
};

// In order of windows and kinds, all kinds of each window.
std::vector<PathTerm> ListTerms(const PlannedWorld& world,
                                const TeamMember& member,
                                const Pathlet& pathlet);
double Sum(const std::vector<PathTerm>& terms);

// The facts that a term goes back to.
kg_compiler::Facts TermFacts(const PlannedWorld& world,
                             const kg_mission::Agent& agent,
                             const PathTerm& term);

// The terms of a path that are not 0.
std::vector<kg_compiler::Contribution> PathContributions(
    const PlannedWorld& world, const TeamMember& member,
    const Pathlet& pathlet);
// Score of `chosen` less that of `other`, by terms that differ.
kg_compiler::Explanation Difference(const PlannedWorld& world,
                                    const TeamMember& member,
                                    const Pathlet& chosen,
                                    const Pathlet& other);

// An agent's best path around those committed before it, under masks besides.
// With soft separation: the best of its K best, penalties counted. `except`:
// not this one.
struct PathSearch {
  kg_planner::PathMasks masks;
  const Pathlet* except = nullptr;
};
struct FoundPath {
  std::optional<Pathlet> pathlet;
  bool proven = true;
};
FoundPath FindBest(const PlannedWorld& world, const TeamMember& member,
                   const PathSearch& search);

// "w2 value: ..." for one term.
std::string Describe(const PathTerm& term);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_PATH_TERMS_H_
