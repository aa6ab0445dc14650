#include "kg_core/rdf/quad_index.h"

#include <algorithm>
#include <future>

namespace kg_core {
namespace {

using Place = TermId Quad::*;

// Components of a key from most to least significant, indexed by QuadOrder.
constexpr Place kPlaces[kQuadOrders][4] = {
    {&Quad::subject, &Quad::predicate, &Quad::object, &Quad::graph},
    {&Quad::predicate, &Quad::object, &Quad::subject, &Quad::graph},
    {&Quad::object, &Quad::subject, &Quad::predicate, &Quad::graph},
    {&Quad::graph, &Quad::subject, &Quad::predicate, &Quad::object},
};

constexpr OrderUse kSpog(int prefix) { return {QuadOrder::kSpog, prefix}; }
constexpr OrderUse kPosg(int prefix) { return {QuadOrder::kPosg, prefix}; }
constexpr OrderUse kOspg(int prefix) { return {QuadOrder::kOspg, prefix}; }
constexpr OrderUse kGspo(int prefix) { return {QuadOrder::kGspo, prefix}; }

constexpr std::array<PatternPlan, 16> kPlans = {{
    {kGspo(0), kGspo(0)},  // (nothing bound)
    {kGspo(1), kGspo(1)},  // G
    {kOspg(1), kOspg(1)},  // O
    {kOspg(1), kGspo(1)},  // O G
    {kPosg(1), kPosg(1)},  // P
    {kPosg(1), kGspo(1)},  // P G
    {kPosg(2), kPosg(2)},  // P O
    {kPosg(2), kGspo(1)},  // P O G
    {kSpog(1), kSpog(1)},  // S
    {kGspo(2), kGspo(2)},  // S G
    {kOspg(2), kOspg(2)},  // S O
    {kOspg(2), kGspo(2)},  // S O G
    {kSpog(2), kSpog(2)},  // S P
    {kGspo(3), kGspo(3)},  // S P G
    {kSpog(3), kSpog(3)},  // S P O
    {kSpog(4), kSpog(4)},  // S P O G
}};

bool Fits(const Quad& quad, const Quad& pattern) {
  const auto fits = [&](Place place) {
    return pattern.*place == kNoTerm || pattern.*place == quad.*place;
  };
  return fits(&Quad::subject) && fits(&Quad::predicate) &&
         fits(&Quad::object) && fits(&Quad::graph);
}

std::vector<QuadKey> SortedKeys(const std::vector<Quad>& quads,
                                QuadOrder order) {
  std::vector<QuadKey> keys(quads.size());
  std::transform(quads.begin(), quads.end(), keys.begin(),
                 [&](const Quad& quad) { return PackQuad(quad, order); });
  if (!std::is_sorted(keys.begin(), keys.end())) {
    std::sort(keys.begin(), keys.end());
  }
  return keys;
}

std::vector<QuadKey> Merged(const QuadTree& tree,
                            const std::vector<QuadKey>& keys) {
  std::vector<QuadKey> all;
  all.reserve(tree.size() + keys.size());
  auto next = keys.begin();
  constexpr std::uint64_t kLargest = ~std::uint64_t{0};
  tree.Scan({0, 0}, {kLargest, kLargest}, [&](const QuadKey& old) {
    while (next != keys.end() && *next < old) all.push_back(*next++);
    all.push_back(old);
    return true;
  });
  all.insert(all.end(), next, keys.end());
  return all;
}

}  // namespace

QuadKey PackQuad(const Quad& quad, QuadOrder order) {
  const auto& places = kPlaces[static_cast<int>(order)];
  return {std::uint64_t{quad.*places[0]} << 32 | quad.*places[1],
          std::uint64_t{quad.*places[2]} << 32 | quad.*places[3]};
}

Quad UnpackQuad(const QuadKey& key, QuadOrder order) {
  const auto& places = kPlaces[static_cast<int>(order)];
  Quad quad;
  quad.*places[0] = static_cast<TermId>(key.high >> 32);
  quad.*places[1] = static_cast<TermId>(key.high);
  quad.*places[2] = static_cast<TermId>(key.low >> 32);
  quad.*places[3] = static_cast<TermId>(key.low);
  return quad;
}

const std::array<PatternPlan, 16>& PatternPlans() { return kPlans; }

int BoundPlaces(const Quad& pattern) {
  return (pattern.subject != kNoTerm ? 8 : 0) +
         (pattern.predicate != kNoTerm ? 4 : 0) +
         (pattern.object != kNoTerm ? 2 : 0) +
         (pattern.graph != kNoTerm ? 1 : 0);
}

QuadIndex::QuadIndex(const std::vector<Quad>& quads) {
  // Two threads with two trees each: the target machines have two cores.
  const auto build = [&](int i) {
    trees_[i] =
        QuadTree::FromSorted(SortedKeys(quads, static_cast<QuadOrder>(i)));
  };
  const auto other = std::async(std::launch::async, [&] {
    build(0);
    build(1);
  });
  build(2);
  build(3);
  other.wait();
}

void QuadIndex::InsertAll(std::vector<Quad> quads, std::uint64_t edit) {
  constexpr std::size_t kMany = 1000;
  if (quads.size() < kMany) {
    for (const Quad& quad : quads) Insert(quad, edit);
    return;
  }
  // Merging into sorted keys and rebuilding is linear; it pays off once the
  // batch is comparable to the index.
  const bool anew = quads.size() >= size() / 2;
  for (int i = 0; i < kQuadOrders; ++i) {
    const auto keys = SortedKeys(quads, static_cast<QuadOrder>(i));
    if (anew) {
      trees_[i] = QuadTree::FromSorted(Merged(trees_[i], keys));
    } else {
      for (const QuadKey& key : keys) trees_[i].Insert(key, edit);
    }
  }
}

bool QuadIndex::Insert(const Quad& quad, std::uint64_t edit) {
  bool inserted = false;
  for (int i = 0; i < kQuadOrders; ++i) {
    inserted =
        trees_[i].Insert(PackQuad(quad, static_cast<QuadOrder>(i)), edit);
    if (!inserted) break;  // Duplicate: already found in the first tree.
  }
  return inserted;
}

bool QuadIndex::Erase(const Quad& quad, std::uint64_t edit) {
  bool erased = false;
  for (int i = 0; i < kQuadOrders; ++i) {
    erased = trees_[i].Erase(PackQuad(quad, static_cast<QuadOrder>(i)), edit);
    if (!erased) break;
  }
  return erased;
}

bool QuadIndex::Contains(const Quad& quad) const {
  return trees_[0].Contains(PackQuad(quad, QuadOrder::kSpog));
}

QuadIndex::Scan QuadIndex::MakeScan(const Quad& pattern,
                                    const OrderUse& use) const {
  const int order = static_cast<int>(use.order);
  constexpr TermId kLargest = 0xFFFFFFFF;
  Quad first, last{kLargest, kLargest, kLargest, kLargest};
  for (int i = 0; i < use.prefix; ++i) {
    const Place place = kPlaces[order][i];
    first.*place = last.*place = pattern.*place;
  }
  Scan scan{use, PackQuad(first, use.order), PackQuad(last, use.order), 0};
  scan.length = trees_[order].CountBetween(scan.first, scan.last);
  return scan;
}

QuadIndex::Scan QuadIndex::ShortestScan(const Quad& pattern) const {
  const PatternPlan& plan = kPlans[BoundPlaces(pattern)];
  const Scan best = MakeScan(pattern, plan.best);
  if (plan.other.order == plan.best.order) return best;
  const Scan other = MakeScan(pattern, plan.other);
  return other.length < best.length ? other : best;
}

void QuadIndex::Match(const Quad& pattern,
                      absl::FunctionRef<bool(const Quad&)> visit) const {
  const Scan scan = ShortestScan(pattern);
  if (scan.length == 0) return;
  const QuadTree& tree = trees_[static_cast<int>(scan.use.order)];
  tree.Scan(scan.first, scan.last, [&](const QuadKey& key) {
    const Quad quad = UnpackQuad(key, scan.use.order);
    return !Fits(quad, pattern) || visit(quad);
  });
}

std::size_t QuadIndex::Estimate(const Quad& pattern) const {
  return ShortestScan(pattern).length;
}

std::vector<bool> QuadIndex::UsedTerms(TermId end) const {
  std::vector<bool> used(end);
  Match({}, [&](const Quad& q) {
    for (const TermId id : {q.subject, q.predicate, q.object, q.graph}) {
      used[id] = true;
    }
    return true;
  });
  return used;
}

std::vector<TermId> QuadIndex::Graphs() const {
  std::vector<TermId> graphs;
  const QuadTree& tree = trees_[static_cast<int>(QuadOrder::kGspo)];
  const auto next = [&](const QuadKey& key) {
    graphs.push_back(UnpackQuad(key, QuadOrder::kGspo).graph);
    return false;
  };
  constexpr QuadKey kLast{~std::uint64_t{0}, ~std::uint64_t{0}};
  std::size_t known = 0;
  do {
    known = graphs.size();
    const TermId graph = graphs.empty() ? kNoTerm : graphs.back();
    tree.Scan({std::uint64_t{graph + 1} << 32, 0}, kLast, next);
  } while (graphs.size() > known);
  return graphs;
}

}  // namespace kg_core
