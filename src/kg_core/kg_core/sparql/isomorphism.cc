#include "kg_core/sparql/isomorphism.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>

#include "absl/hash/hash.h"

namespace kg_core {
namespace {

using Color = std::size_t;
// A quad of term numbers (>= 0); a blank node with index i is -1 - i.
using Places = std::array<int, 4>;
using Colors = std::vector<Color>;

int GetBlankIndex(int place) { return -1 - place; }
bool IsBlank(int place) { return place < 0; }

struct BlankNodeGraph {
  std::set<Places> quads;
  std::size_t blanks = 0;
};

// `ground` numbers the terms that are not blank nodes, shared by both graphs.
BlankNodeGraph GetGraph(const std::vector<Statement>& statements,
                        std::map<Term, int>* ground) {
  BlankNodeGraph graph;
  std::map<Term, int> blanks;
  const auto number = [&](const Term& term) {
    std::map<Term, int>& numbers = term.is_blank() ? blanks : *ground;
    const int next = static_cast<int>(numbers.size());
    const int known = numbers.emplace(term, next).first->second;
    return term.is_blank() ? -1 - known : known;
  };
  for (const Statement& s : statements) {
    graph.quads.insert({number(s.subject), number(s.predicate),
                        number(s.object), number(s.graph)});
  }
  graph.blanks = blanks.size();
  return graph;
}

std::size_t GetCount(const Colors& colors) {
  return std::set<Color>(colors.begin(), colors.end()).size();
}

// One step of color refinement: new colors of the blank nodes from their quads.
Colors Refined(const BlankNodeGraph& graph, const Colors& colors) {
  std::vector<std::vector<Color>> said(graph.blanks);
  // A blank node's new color depends on the quads it is in: the colors of their
  // members and the positions that the node itself occupies.
  for (const Places& quad : graph.quads) {
    std::array<Color, 4> seen;
    for (std::size_t i = 0; i < 4; ++i) {
      seen[i] = IsBlank(quad[i])
                    ? colors[static_cast<std::size_t>(GetBlankIndex(quad[i]))]
                    : absl::HashOf(quad[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (!IsBlank(quad[i])) continue;
      std::array<bool, 4> here;
      for (std::size_t j = 0; j < 4; ++j) here[j] = quad[j] == quad[i];
      said[static_cast<std::size_t>(GetBlankIndex(quad[i]))].push_back(
          absl::HashOf(seen, here));
    }
  }
  Colors refined(graph.blanks);
  for (std::size_t i = 0; i < refined.size(); ++i) {
    std::sort(said[i].begin(), said[i].end());
    refined[i] = absl::HashOf(colors[i], said[i]);
  }
  return refined;
}

class GraphMatcher {
 public:
  GraphMatcher(const BlankNodeGraph& a, const BlankNodeGraph& b)
      : a_(a), b_(b) {}

  // True if there is a bijection of the blank nodes that preserves colors and
  // quads.
  bool Match(Colors a, Colors b) {
    std::size_t count = 0;
    while (count < GetCount(a)) {
      count = GetCount(a);
      a = Refined(a_, a);
      b = Refined(b_, b);
    }
    Colors sorted_a = a;
    Colors sorted_b = b;
    std::sort(sorted_a.begin(), sorted_a.end());
    std::sort(sorted_b.begin(), sorted_b.end());
    if (sorted_a != sorted_b) return false;
    if (count == a.size()) return Agree(a, b);
    const auto twice = std::adjacent_find(sorted_a.begin(), sorted_a.end());
    return Choose(*twice, a, b);
  }

 private:
  // Backtracking: tries every partner for one blank node of that color.
  bool Choose(Color color, Colors a, const Colors& b) {
    const Color fresh = absl::HashOf(color, ++choices_);
    *std::find(a.begin(), a.end(), color) = fresh;
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (b[i] != color) continue;
      Colors chosen = b;
      chosen[i] = fresh;
      if (Match(a, chosen)) return true;
    }
    return false;
  }

  // Final check; precondition: each color belongs to exactly one blank node on
  // each side.
  bool Agree(const Colors& a, const Colors& b) const {
    std::map<Color, int> partners;
    for (std::size_t i = 0; i < b.size(); ++i) {
      partners[b[i]] = -1 - static_cast<int>(i);
    }
    std::set<Places> moved;
    for (Places quad : a_.quads) {
      for (int& place : quad) {
        if (!IsBlank(place)) continue;
        place = partners.at(a[static_cast<std::size_t>(GetBlankIndex(place))]);
      }
      moved.insert(quad);
    }
    return moved == b_.quads;
  }

  const BlankNodeGraph& a_;
  const BlankNodeGraph& b_;
  std::size_t choices_ = 0;
};

}  // namespace

bool IsIsomorphic(const std::vector<Statement>& a,
                  const std::vector<Statement>& b) {
  std::map<Term, int> ground;
  const BlankNodeGraph left = GetGraph(a, &ground);
  const BlankNodeGraph right = GetGraph(b, &ground);
  if (left.quads.size() != right.quads.size() || left.blanks != right.blanks) {
    return false;
  }
  return GraphMatcher(left, right)
      .Match(Colors(left.blanks), Colors(right.blanks));
}

}  // namespace kg_core
