#include "kg_core/shacl/data_graph.h"

#include <utility>

#include "kg_core/rdf/namespaces.h"

namespace kg_core::shacl {

std::vector<Term> Step(const DataGraph& data, const Term& node,
                       const Term& predicate, Direction direction) {
  const bool forward = direction == Direction::kForward;
  std::vector<Term> found =
      forward ? Objects(data.view, data.graph, node, predicate)
              : Subjects(data.view, data.graph, predicate, node);
  if (data.removed == nullptr) return found;
  for (const Statement& s : *data.removed) {
    if (s.graph.text != data.graph || s.predicate != predicate) continue;
    if ((forward ? s.subject : s.object) != node) continue;
    found.push_back(forward ? s.object : s.subject);
  }
  return found;
}

std::set<Term> ClassesBelow(const GraphView& view,
                            const std::vector<std::string>& graphs,
                            const Term& top) {
  const Term sub_class_of = Iri(std::string(kRdfs) + "subClassOf");
  std::set<Term> classes;
  std::vector<Term> open = {top};
  while (!open.empty()) {
    const Term next = std::move(open.back());
    open.pop_back();
    if (!classes.insert(next).second) continue;
    for (const std::string& graph : graphs) {
      for (Term& below : Subjects(view, graph, sub_class_of, next)) {
        open.push_back(std::move(below));
      }
    }
  }
  return classes;
}

}  // namespace kg_core::shacl
