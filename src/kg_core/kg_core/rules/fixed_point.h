// All that rules conclude from a state, and why.
//
// Strata are run one after another (strata.h). In one that is recursive, all
// rules are run on what has been concluded so far, in rounds, until a round
// brings nothing new. A blank node of a template becomes an IRI that is made of
// the rule and of the values of the template's variables, so that a rule which
// only says "there is one" ends.
//
// Reasons are kept of rules that are not recursive: all there are; of recursive
// ones: those of the round that first had the conclusion. So no reason
// rests on itself, and what is kept does not depend on the history of the
// facts; nor does the choice, where there are more than `reasons`.

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
  int rounds = 1000;                      // Of one stratum.
  std::size_t conclusions = 50000;        // Triples.
  std::size_t premises = 1000;            // Of one inference.
  std::size_t statements = 1000000;       // Of conclusions and reasons.
  std::size_t working_bytes = 256 << 20;  // Of one rule in one round.
  std::size_t reasons = 8;                // Kept of a triple: the first by IRI.
};

// One or more for every conclusion. Throws InputError that names a rule, or the
// limit that was hit.
std::vector<Inference> RunRules(const std::vector<Rule>& rules,
                                const GraphView& view,
                                const InferenceLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_RULES_FIXED_POINT_H_
