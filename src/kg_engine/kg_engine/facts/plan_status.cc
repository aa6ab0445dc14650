#include "kg_engine/facts/plan_status.h"

#include "kg_core/facts/terms.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {

void StagePlanStatus(const std::uint64_t run, const char* status,
                     kg_core::Transaction* transaction) {
  const kg_core::Term node = PlanRunNode(run);
  const kg_core::Term property = kg_core::Ex("status");
  const kg_core::Term graph = PlanGraph(run);
  const kg_core::GraphView& view = transaction->view();
  if (!kg_core::FirstObject(view, graph.text, node, property)) return;
  transaction->RemoveMatching(&node, &property, nullptr, graph);
  transaction->Add({node, property, kg_core::Literal(status), graph});
}

}  // namespace kg_engine
