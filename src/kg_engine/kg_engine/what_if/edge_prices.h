// Costs of the edges of one world's graphs in another world: the paper's "which
// TraverseEdges would become too costly".

#ifndef KG_ENGINE_WHAT_IF_EDGE_PRICES_H_
#define KG_ENGINE_WHAT_IF_EDGE_PRICES_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_engine {

// A world with the plan that the nodes would commit for it.
struct CompiledPlan {
  std::shared_ptr<const kg_compiler::Compilation> compilation;
  kg_selector::PlannedMission planned;
};

// Source position of an edge of graph `window` (index in the member's graphs).
kg_base::LonLat BeginOf(const kg_selector::TeamMember& member,
                        std::size_t window,
                        const kg_compiler::TraverseEdge& edge);

// Edges are identified by indices: member, its graph, the graph's edge. Prices
// are those of the graphs of `then` if they contain the same route; otherwise
// the route is flown again under the rules of `then`.
class EdgePrices {
 public:
  // Both must outlive this object.
  EdgePrices(const kg_selector::PlannedMission& now, const CompiledPlan& then);

  // Null = infeasible in `then`, or its agent or window no longer exists.
  const kg_compiler::TraverseEdge* Then(std::size_t member, std::size_t window,
                                        std::size_t edge) const;

 private:
  struct WindowPrices {
    bool same = false;  // True: prices are unchanged.
    // Edge in `then`, by edge.
    std::vector<std::optional<kg_compiler::TraverseEdge>> then;
  };
  WindowPrices PriceWindow(const kg_selector::TeamMember& member,
                           std::size_t window, const CompiledPlan& then) const;

  const kg_selector::PlannedMission& now_;
  // Indexed by member and graph.
  std::vector<std::vector<WindowPrices>> prices_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_EDGE_PRICES_H_
