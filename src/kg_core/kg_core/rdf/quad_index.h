// Index of the quads of one state: four sort orders, and the choice of order
// for each pattern.

#ifndef KG_CORE_RDF_QUAD_INDEX_H_
#define KG_CORE_RDF_QUAD_INDEX_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/quad_tree.h"

namespace kg_core {

enum class QuadOrder { kSpog, kPosg, kOspg, kGspo };
inline constexpr int kQuadOrders = 4;

QuadKey PackQuad(const Quad& quad, QuadOrder order);
Quad UnpackQuad(const QuadKey& key, QuadOrder order);

// A range scan in `order`, bounded by the first `prefix` components of the
// pattern.
struct OrderUse {
  QuadOrder order;
  int prefix;
};

// `best` has the longest bound prefix. If a bound component then remains to be
// filtered, `other` may be the shorter scan; else both are equal.
struct PatternPlan {
  OrderUse best;
  OrderUse other;
};

// Plans indexed by the set of bound components: subject 8 + predicate 4 +
// object 2 + graph 1.
const std::array<PatternPlan, 16>& PatternPlans();
int BoundPlaces(const Quad& pattern);

// A value type whose copies share tree nodes (see quad_tree.h).
class QuadIndex {
 public:
  QuadIndex() = default;
  explicit QuadIndex(const std::vector<Quad>& quads);  // No duplicates.

  // False if already present.
  bool Insert(const Quad& quad, std::uint64_t edit);
  bool Erase(const Quad& quad, std::uint64_t edit);  // False if absent.
  // Inserts quads that are not yet present, without duplicates. For batches of
  // at least 1000 quads and half of size(), the trees are rebuilt from sorted
  // keys.
  void InsertAll(std::vector<Quad> quads, std::uint64_t edit);

  std::size_t size() const { return trees_[0].size(); }
  bool Contains(const Quad& quad) const;
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const;
  // Number of keys that Match would scan: the exact count of matches, or an
  // upper bound if Match has to filter.
  std::size_t Estimate(const Quad& pattern) const;
  // For each id below `end`: whether any quad uses the term.
  std::vector<bool> UsedTerms(TermId end) const;
  // The graphs with at least one quad, in id order. One tree search per graph,
  // independent of the number of quads.
  std::vector<TermId> Graphs() const;

 private:
  struct Scan {
    OrderUse use;
    QuadKey first, last;
    std::size_t length;
  };
  Scan MakeScan(const Quad& pattern, const OrderUse& use) const;
  Scan ShortestScan(const Quad& pattern) const;

  std::array<QuadTree, kQuadOrders> trees_;  // Indexed by QuadOrder.
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_QUAD_INDEX_H_
