// Why a seam costs what it costs:
//
//   S = lambda_time t + lambda_energy E + lambda_risk (H + I)
//       + lambda_unc (1 - w) + sum of lambda_field X     (seam_cost.h)
//   E = energy_per_m (V t + m held on station) + hotel_load (whole window)
//
// each product a contribution, the energy's three and the risk's two apart.
// Terms of weight 0 are left out.

#ifndef KG_COMPILER_EXPLAIN_EXPLAIN_SEAM_H_
#define KG_COMPILER_EXPLAIN_EXPLAIN_SEAM_H_

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/explain/cited_facts.h"
#include "kg_compiler/explain/explanation.h"

namespace kg_compiler {

// One agent's seams into one window.
struct SeamContext {
  const Compilation* compilation = nullptr;
  const kg_mission::Agent* agent = nullptr;
  const SeamRules* rules = nullptr;
  const WindowRules* window = nullptr;
};
// Throws kg_core::InputError if the window is not planned.
SeamContext FindSeamContext(const Compilation& compilation,
                            const kg_mission::Agent& agent,
                            const SeamRules& rules, int window);

// In reward units; the value is the edge's seam_cost.
Explanation ExplainSeam(const SeamContext& context, const TraverseEdge& edge,
                        const CitedFacts& facts);

// Facts of the ways into the window: its times, how the agent moves, and the
// work field down to its file.
Facts MotionFacts(const SeamContext& context, const CitedFacts& facts);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLAIN_SEAM_H_
