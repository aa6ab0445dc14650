// Test whether two snapshots show the same committed state of a store.

#ifndef KG_CORE_RDF_SAME_STATE_H_
#define KG_CORE_RDF_SAME_STATE_H_

#include "kg_core/rdf/graph_view.h"

namespace kg_core {

// True if both are snapshots (from Store::Read()) of the same committed
// version. Commits with WorldChange::kNo also make a difference. False for
// other kinds of view.
bool IsSameState(const GraphView& a, const GraphView& b);

}  // namespace kg_core

#endif  // KG_CORE_RDF_SAME_STATE_H_
