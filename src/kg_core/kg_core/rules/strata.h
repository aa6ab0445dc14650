// The order in which rules are run: what a rule reads negatively must be
// complete before.

#ifndef KG_CORE_RULES_STRATA_H_
#define KG_CORE_RULES_STRATA_H_

#include <vector>

#include "kg_core/rules/rule.h"

namespace kg_core {

// Rules that depend on each other only.
struct Stratum {
  std::vector<const Rule*> rules;
  bool recursive = false;  // What they write, they read.
};

// Each after those that write what it reads. Points into `rules`. Throws
// InputError if a rule negatively reads what follows from its own conclusions:
// then facts alone would not say what is true.
std::vector<Stratum> Stratify(const std::vector<Rule>& rules);

}  // namespace kg_core

#endif  // KG_CORE_RULES_STRATA_H_
