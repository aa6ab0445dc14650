// Stratification of the rules: kinds that a rule reads negatively must be
// complete before it runs.

#ifndef KG_CORE_RULES_STRATA_H_
#define KG_CORE_RULES_STRATA_H_

#include <vector>

#include "kg_core/rules/rule.h"

namespace kg_core {

// A set of mutually dependent rules (a strongly connected component).
struct Stratum {
  std::vector<const Rule*> rules;
  bool recursive = false;  // The rules read what they write.
};

// The strata in order of evaluation: each follows those that write what it
// reads. Points into `rules`. Throws InputError if a rule negatively reads a
// consequence of its own conclusions: the fixed point would then be ambiguous.
std::vector<Stratum> Stratify(const std::vector<Rule>& rules);

}  // namespace kg_core

#endif  // KG_CORE_RULES_STRATA_H_
