// Conflicts between pairs of columns as cliques, of which at most one column
// may be chosen: fewer rows than pairs, and a closer relaxation.

#ifndef KG_SELECTOR_PACKING_PACKING_CLIQUES_H_
#define KG_SELECTOR_PACKING_PACKING_CLIQUES_H_

#include <utility>
#include <vector>

namespace kg_selector {

// Every pair is within one of the cliques, and every two members of a clique
// are a pair. Greedy, in the order of the columns; each ascending.
std::vector<std::vector<int>> FindCliques(
    int columns, const std::vector<std::pair<int, int>>& conflicts);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PACKING_PACKING_CLIQUES_H_
