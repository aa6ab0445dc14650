// Explains the cost of a seam by its terms:
//
//   S = lambda_time t + lambda_energy E + lambda_risk (H + I)
//       + lambda_unc (1 - w) + lambda_turn T + sum of lambda_field X
//       (seam_cost.h)
//   E = energy_per_m (V t + m held on station) + hotel_load (whole window)
//
// Each product is a contribution; the three parts of energy and the two of risk
// are listed separately. Terms of weight 0 are omitted.

#ifndef KG_COMPILER_EXPLAIN_EXPLAIN_SEAM_H_
#define KG_COMPILER_EXPLAIN_EXPLAIN_SEAM_H_

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/explain/cited_facts.h"
#include "kg_compiler/explain/explanation.h"

namespace kg_compiler {

// Inputs for explaining one agent's seams into one window.
struct SeamContext {
  const Compilation* compilation = nullptr;
  const kg_mission::Agent* agent = nullptr;
  const SeamRules* rules = nullptr;
  const WindowRules* window = nullptr;
};
// Throws kg_base::InputError if the window is not planned.
SeamContext FindSeamContext(const Compilation& compilation,
                            const kg_mission::Agent& agent,
                            const SeamRules& rules, int window);

// Explains the edge's seam_cost, in reward units.
Explanation ExplainSeam(const SeamContext& context, const TraverseEdge& edge,
                        const CitedFacts& facts);

// Facts behind all flights into the window: its times, the motion of the agent,
// and the work field down to its file.
Facts MotionFacts(const SeamContext& context, const CitedFacts& facts);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLAIN_SEAM_H_
