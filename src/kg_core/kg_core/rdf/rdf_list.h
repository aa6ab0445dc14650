// Reader for RDF lists.

#ifndef KG_CORE_RDF_RDF_LIST_H_
#define KG_CORE_RDF_RDF_LIST_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"

namespace kg_core {

// The members of the list at `node`; nullopt if the list is malformed or
// cyclic. https://www.w3.org/TR/shacl/#dfn-shacl-list
std::optional<std::vector<Term>> ReadList(const GraphView& view,
                                          const std::string& graph, Term node);

}  // namespace kg_core

#endif  // KG_CORE_RDF_RDF_LIST_H_
