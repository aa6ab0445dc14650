#include "kg_core/sparql/isomorphism.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kg_core {
namespace {

using Edge = std::pair<int, int>;
using Edges = std::vector<Edge>;

std::vector<Statement> GetGraph(const Edges& edges,
                                const std::vector<int>& labels) {
  std::vector<Statement> statements;
  const auto node = [&labels](int i) {
    return Blank("n" + std::to_string(labels[static_cast<std::size_t>(i)]));
  };
  for (const Edge& edge : edges) {
    statements.push_back(
        {node(edge.first), Iri("urn:p"), node(edge.second), Iri("urn:g")});
  }
  return statements;
}

// Reference: tries all permutations.
bool IsIsomorphicByBruteForce(const Edges& a, const Edges& b, int nodes) {
  std::vector<int> to(static_cast<std::size_t>(nodes));
  for (int i = 0; i < nodes; ++i) to[static_cast<std::size_t>(i)] = i;
  const std::set<Edge> wanted(b.begin(), b.end());
  do {
    std::set<Edge> moved;
    for (const Edge& edge : a) {
      moved.insert({to[static_cast<std::size_t>(edge.first)],
                    to[static_cast<std::size_t>(edge.second)]});
    }
    if (moved == wanted) return true;
  } while (std::next_permutation(to.begin(), to.end()));
  return false;
}

TEST(Isomorphism, AgreesWithTryingEveryPermutation) {
  std::mt19937 random(7);
  constexpr int kNodes = 5;
  const std::vector<int> same = {0, 1, 2, 3, 4};
  int equal = 0;
  for (int round = 0; round < 2000; ++round) {
    Edges a;
    Edges b;
    const auto edge = [&random] {
      return Edge(static_cast<int>(random() % kNodes),
                  static_cast<int>(random() % kNodes));
    };
    // Every node occurs, so that both sides have the same number of blank
    // nodes.
    for (int i = 0; i < kNodes; ++i) a.emplace_back(i, edge().second);
    for (int i = 0; i < kNodes; ++i) b.emplace_back(i, edge().second);
    const bool want = IsIsomorphicByBruteForce(a, b, kNodes);
    EXPECT_EQ(IsIsomorphic(GetGraph(a, same), GetGraph(b, same)), want);
    equal += want ? 1 : 0;
  }
  EXPECT_GT(equal, 50);
  EXPECT_LT(equal, 1950);
}

TEST(Isomorphism, FindsARenamedGraphOfLookAlikes) {
  // A ring of 12 blank nodes, which are all indistinguishable.
  Edges ring;
  std::vector<int> labels;
  for (int i = 0; i < 12; ++i) ring.emplace_back(i, (i + 1) % 12);
  for (int i = 0; i < 12; ++i) labels.push_back((i * 5 + 3) % 12);
  std::vector<int> same(12);
  for (int i = 0; i < 12; ++i) same[static_cast<std::size_t>(i)] = i;
  EXPECT_TRUE(IsIsomorphic(GetGraph(ring, same), GetGraph(ring, labels)));
  // Two rings of six have the same degrees.
  Edges two;
  for (int i = 0; i < 12; ++i) {
    two.emplace_back(i, i < 6 ? (i + 1) % 6 : 6 + (i + 1) % 6);
  }
  EXPECT_FALSE(IsIsomorphic(GetGraph(ring, same), GetGraph(two, same)));
}

TEST(Isomorphism, DistinguishesGroundTermsAndGraphs) {
  const Statement base{Iri("urn:s"), Iri("urn:p"), Literal("1"), Iri("urn:g")};
  EXPECT_TRUE(IsIsomorphic({base, base}, {base}));
  EXPECT_TRUE(IsIsomorphic({}, {}));
  EXPECT_FALSE(IsIsomorphic({base}, {}));
  Statement other = base;
  other.graph = Iri("urn:h");
  EXPECT_FALSE(IsIsomorphic({base}, {other}));
  other = base;
  other.object = LanguageLiteral("1", "en");
  EXPECT_FALSE(IsIsomorphic({base}, {other}));
  other.object = Blank("x");
  EXPECT_FALSE(IsIsomorphic({base}, {other}));
}

}  // namespace
}  // namespace kg_core
