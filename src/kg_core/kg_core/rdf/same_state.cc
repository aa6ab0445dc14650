#include "kg_core/rdf/same_state.h"

#include "kg_core/rdf/snapshot.h"

namespace kg_core {

bool IsSameState(const GraphView& a, const GraphView& b) {
  const auto* first = dynamic_cast<const Snapshot*>(&a);
  const auto* second = dynamic_cast<const Snapshot*>(&b);
  return first != nullptr && second != nullptr &&
         &first->version() == &second->version();
}

}  // namespace kg_core
