// Fixed point of the rules on a state, with the reason for each conclusion.
//
// Strata are evaluated in order (strata.h). In a recursive stratum, all rules
// are run in rounds on the conclusions so far until a round adds nothing new. A
// blank node of a template becomes an IRI derived from the rule and the values
// of the template's variables, so that purely existential rules terminate.
//
// For non-recursive rules all reasons are kept; for recursive ones those of the
// round that first reached the conclusion. So no reason is circular, and the
// reasons kept do not depend on the history of the facts; neither does the
// selection if there are more than `reasons`.

#ifndef KG_CORE_RULES_FIXED_POINT_H_
#define KG_CORE_RULES_FIXED_POINT_H_

#include <cstddef>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rules/reasons.h"
#include "kg_core/rules/rule.h"

namespace kg_core {

struct InferenceLimits {
  double seconds = 2.0;
  int rounds = 1000;                      // Rounds per stratum.
  std::size_t conclusions = 50000;        // Concluded triples.
  std::size_t premises = 1000;            // Premises per inference.
  std::size_t statements = 1000000;       // Conclusions and reasons.
  std::size_t working_bytes = 256 << 20;  // Per rule and round.
  std::size_t reasons = 8;                // Kept per triple: first by IRI.
};

// Returns one or more inferences for every conclusion. Throws InputError that
// names a rule or the exceeded limit.
std::vector<Inference> RunRules(const std::vector<Rule>& rules,
                                const GraphView& view,
                                const InferenceLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_RULES_FIXED_POINT_H_
