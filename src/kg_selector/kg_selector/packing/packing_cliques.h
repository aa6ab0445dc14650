// Merges pairwise conflicts of columns into cliques, of which at most one
// column may be chosen: fewer rows and a tighter relaxation.

#ifndef KG_SELECTOR_PACKING_PACKING_CLIQUES_H_
#define KG_SELECTOR_PACKING_PACKING_CLIQUES_H_

#include <utility>
#include <vector>

namespace kg_selector {

// Cliques that cover every pair; any two members of a clique are a pair. Greedy
// in column order; each clique ascending.
std::vector<std::vector<int>> FindCliques(
    int columns, const std::vector<std::pair<int, int>>& conflicts);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PACKING_PACKING_CLIQUES_H_
