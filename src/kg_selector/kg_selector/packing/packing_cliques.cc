#include "kg_selector/packing/packing_cliques.h"

#include <algorithm>
#include <set>

namespace kg_selector {

std::vector<std::vector<int>> FindCliques(
    int columns, const std::vector<std::pair<int, int>>& conflicts) {
  std::vector<std::vector<int>> others(columns);  // Ascending.
  std::set<std::pair<int, int>> open;
  for (const auto& [a, b] : conflicts) {
    others[a].push_back(b);
    others[b].push_back(a);
    open.insert(std::minmax(a, b));
  }
  for (auto& list : others) std::sort(list.begin(), list.end());
  std::vector<std::vector<int>> cliques;
  while (!open.empty()) {
    const auto [a, b] = *open.begin();
    std::vector<int> clique{a, b};
    for (int c : others[a]) {
      const bool joins =
          c != b && std::all_of(clique.begin(), clique.end(), [&](int d) {
            return c != d &&
                   std::binary_search(others[d].begin(), others[d].end(), c);
          });
      if (joins) clique.push_back(c);
    }
    std::sort(clique.begin(), clique.end());
    for (std::size_t i = 0; i < clique.size(); ++i) {
      for (std::size_t j = i + 1; j < clique.size(); ++j) {
        open.erase({clique[i], clique[j]});
      }
    }
    cliques.push_back(std::move(clique));
  }
  return cliques;
}

}  // namespace kg_selector
