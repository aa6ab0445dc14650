// The quads of one state in four orders, and which order answers a pattern.

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

// Scan the range of `order` that the first `prefix` places of the pattern give.
struct OrderUse {
  QuadOrder order;
  int prefix;
};

// `best` has the longest prefix. Where that leaves a bound place to be
// filtered, `other` may be the shorter scan; else both are the same.
struct PatternPlan {
  OrderUse best;
  OrderUse other;
};

// By which places are bound: subject 8 + predicate 4 + object 2 + graph 1.
const std::array<PatternPlan, 16>& PatternPlans();
int BoundPlaces(const Quad& pattern);

// A value: copies share their nodes (see quad_tree.h).
class QuadIndex {
 public:
  QuadIndex() = default;
  explicit QuadIndex(const std::vector<Quad>& quads);  // Without duplicates.

  bool Insert(const Quad& quad, std::uint64_t edit);  // False if there.
  bool Erase(const Quad& quad, std::uint64_t edit);   // False if not there.
  // Quads that are not there, without duplicates. Where they are many, the
  // trees are made anew, from sorted keys.
  void InsertAll(std::vector<Quad> quads, std::uint64_t edit);

  std::size_t size() const { return trees_[0].size(); }
  bool Contains(const Quad& quad) const;
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const;
  // Length of the scan that Match would make: exact, or an upper bound where
  // it filters.
  std::size_t Estimate(const Quad& pattern) const;
  // By id, below `end`: does a quad use the term?
  std::vector<bool> UsedTerms(TermId end) const;
  // The graphs that have a quad, in the order of their ids: a search for each,
  // however many quads they have.
  std::vector<TermId> Graphs() const;

 private:
  struct Scan {
    OrderUse use;
    QuadKey first, last;
    std::size_t length;
  };
  Scan MakeScan(const Quad& pattern, const OrderUse& use) const;
  Scan ShortestScan(const Quad& pattern) const;

  std::array<QuadTree, kQuadOrders> trees_;  // By QuadOrder.
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_QUAD_INDEX_H_
