#include "kg_core/facts/class_tree.h"

#include <utility>

#include "kg_core/facts/terms.h"

namespace kg_core {

std::set<Term> ClassAndSubclasses(const GraphView& view, const Term& top) {
  std::set<Term> classes;
  std::vector<Term> open = {top};
  while (!open.empty()) {
    const Term next = std::move(open.back());
    open.pop_back();
    if (!classes.insert(next).second) continue;
    for (Term& below : Subjects(view, kVocabGraph, Rdfs("subClassOf"), next)) {
      open.push_back(std::move(below));
    }
  }
  return classes;
}

std::vector<Term> FindInstances(const GraphView& view, std::string_view graph,
                                const Term& top) {
  std::set<Term> instances;
  for (const Term& type : ClassAndSubclasses(view, top)) {
    const std::vector<Term> found = Subjects(view, graph, RdfType(), type);
    instances.insert(found.begin(), found.end());
  }
  return {instances.begin(), instances.end()};
}

}  // namespace kg_core
