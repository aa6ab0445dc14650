// Classes and their instances, by rdfs:subClassOf in the vocabulary.

#ifndef KG_CORE_FACTS_CLASS_TREE_H_
#define KG_CORE_FACTS_CLASS_TREE_H_

#include <set>
#include <string_view>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// `top` and all its subclasses.
std::set<Term> ClassAndSubclasses(const GraphView& view, const Term& top);

// The instances of `top` or a subclass in `graph`; sorted, without duplicates.
std::vector<Term> FindInstances(const GraphView& view, std::string_view graph,
                                const Term& top);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_CLASS_TREE_H_
