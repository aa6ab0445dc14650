// Classes and their instances, through rdfs:subClassOf of the vocabulary.

#ifndef KG_CORE_FACTS_CLASS_TREE_H_
#define KG_CORE_FACTS_CLASS_TREE_H_

#include <set>
#include <string_view>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// `top` and every class below it.
std::set<Term> ClassAndSubclasses(const GraphView& view, const Term& top);

// What `graph` types with `top` or a class below it; sorted, each once.
std::vector<Term> FindInstances(const GraphView& view, std::string_view graph,
                                const Term& top);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_CLASS_TREE_H_
