// The score of a path, term by term, and the score difference of two paths by
// term.
//
//   score = sum over windows of  value + events - time - energy - risk
//           - uncertainty - turn - churn, and with soft separation - separation
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
  kValue,  // Scores of the waypoints visited.
  kEvents,
  kTime,
  kEnergy,
  kRisk,
  kUncertainty,
  kChurn,  // Cost of deviating from the plan in force.
  kSeparation,
  kField,  // Further terms of the seam cost: wave height along the way, ...
  kTurn    // Turn from the start heading.
};
const char* Name(TermKind kind);  // "value", "events", ...

struct PathTerm {
  int window = -1;
  TermKind kind = TermKind::kValue;
  double value = 0.0;  // Costs are negative.
  // Display text: the waypoints, the events' names, or the term's name.
  std::string where;
  std::vector<std::string> events = {};  // kEvents: IRIs of the events earned.
};

// Terms sorted by window, then kind; every window has all kinds.
std::vector<PathTerm> ListTerms(const PlannedWorld& world,
                                const TeamMember& member,
                                const Pathlet& pathlet);
double Sum(const std::vector<PathTerm>& terms);

// Facts from which a term was computed.
kg_compiler::Facts TermFacts(const PlannedWorld& world,
                             const kg_mission::Agent& agent,
                             const PathTerm& term);

// Nonzero terms of a path.
std::vector<kg_compiler::Contribution> PathContributions(
    const PlannedWorld& world, const TeamMember& member,
    const Pathlet& pathlet);
// Score of `chosen` minus score of `other`, split into the terms that differ.
kg_compiler::Explanation Difference(const PlannedWorld& world,
                                    const TeamMember& member,
                                    const Pathlet& chosen,
                                    const Pathlet& other);

// Search for an agent's best path around the paths committed before it, under
// additional masks. With soft separation: the best of its K best, penalties
// included. `except`: a path to exclude.
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
