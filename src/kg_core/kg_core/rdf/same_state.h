// Has anything been committed between two snapshots of a store?

#ifndef KG_CORE_RDF_SAME_STATE_H_
#define KG_CORE_RDF_SAME_STATE_H_

#include "kg_core/rdf/graph_view.h"

namespace kg_core {

// Are both (of Store::Read()) one and the same committed state? Also changes
// that are none of the world's count. False for views of other kinds.
bool IsSameState(const GraphView& a, const GraphView& b);

}  // namespace kg_core

#endif  // KG_CORE_RDF_SAME_STATE_H_
