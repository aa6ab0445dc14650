#include "kg_core/rdf/rdf_list.h"

#include <set>

#include "kg_core/rdf/namespaces.h"

namespace kg_core {

std::optional<std::vector<Term>> ReadList(const GraphView& view,
                                          const std::string& graph, Term node) {
  const std::string rdf = kRdf;
  std::vector<Term> members;
  std::set<Term> seen;
  while (node != Iri(rdf + "nil")) {
    const auto first = Objects(view, graph, node, Iri(rdf + "first"));
    const auto rest = Objects(view, graph, node, Iri(rdf + "rest"));
    if (first.size() != 1 || rest.size() != 1 || !seen.insert(node).second) {
      return std::nullopt;
    }
    members.push_back(first[0]);
    node = rest[0];
  }
  return members;
}

}  // namespace kg_core
