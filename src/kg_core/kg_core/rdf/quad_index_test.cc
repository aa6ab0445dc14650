#include "kg_core/rdf/quad_index.h"

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "gtest/gtest.h"

namespace kg_core {
namespace {

auto AsTuple(const Quad& q) {
  return std::make_tuple(q.subject, q.predicate, q.object, q.graph);
}
using Model = std::set<std::tuple<TermId, TermId, TermId, TermId>>;

Quad RandomQuad(std::mt19937* random, TermId terms) {
  const auto pick = [&] {
    return 1 + static_cast<TermId>((*random)() % terms);
  };
  return {pick(), pick(), pick(), pick()};
}

// Keeps only the components of the quad whose bit is set.
Quad MakePattern(Quad quad, int bits) {
  if (!(bits & 8)) quad.subject = kNoTerm;
  if (!(bits & 4)) quad.predicate = kNoTerm;
  if (!(bits & 2)) quad.object = kNoTerm;
  if (!(bits & 1)) quad.graph = kNoTerm;
  return quad;
}

// Number of leading components of the order bound by the pattern.
int LeadingBound(const Quad& pattern, QuadOrder order) {
  const QuadKey key = PackQuad(pattern, order);
  const TermId places[] = {
      static_cast<TermId>(key.high >> 32), static_cast<TermId>(key.high),
      static_cast<TermId>(key.low >> 32), static_cast<TermId>(key.low)};
  return std::find(places, places + 4, kNoTerm) - places;
}

TEST(QuadIndex, PacksAndUnpacksEveryOrder) {
  std::mt19937 random(1);
  for (int i = 0; i < kQuadOrders; ++i) {
    const auto order = static_cast<QuadOrder>(i);
    const Quad quad = RandomQuad(&random, 0xFFFFFFF0);
    EXPECT_EQ(UnpackQuad(PackQuad(quad, order), order), quad);
    EXPECT_EQ(UnpackQuad(PackQuad({1, 2, 3, 4}, order), order),
              (Quad{1, 2, 3, 4}));
  }
}

TEST(QuadIndex, ThePlanOfEveryPatternHasTheLongestPrefix) {
  for (int bits = 0; bits < 16; ++bits) {
    const Quad pattern = MakePattern({1, 2, 3, 4}, bits);
    ASSERT_EQ(BoundPlaces(pattern), bits);
    const PatternPlan& plan = PatternPlans()[bits];
    int longest = 0;
    for (int i = 0; i < kQuadOrders; ++i) {
      longest =
          std::max(longest, LeadingBound(pattern, static_cast<QuadOrder>(i)));
    }
    EXPECT_EQ(plan.best.prefix, longest) << bits;
    EXPECT_EQ(plan.best.prefix, LeadingBound(pattern, plan.best.order));
    EXPECT_EQ(plan.other.prefix, LeadingBound(pattern, plan.other.order));
  }
}

TEST(QuadIndex, MatchesLikeBruteForce) {
  std::mt19937 random(2);
  QuadIndex index;
  Model model;
  for (int round = 0; round < 40; ++round) {
    const std::uint64_t edit = QuadTree::NewEdit();
    for (int i = 0; i < 60; ++i) {
      const Quad quad = RandomQuad(&random, 6);
      if (random() % 3 == 0) {
        ASSERT_EQ(index.Erase(quad, edit), model.erase(AsTuple(quad)) == 1);
      } else {
        ASSERT_EQ(index.Insert(quad, edit), model.insert(AsTuple(quad)).second);
      }
    }
    for (int bits = 0; bits < 16; ++bits) {
      const Quad pattern = MakePattern(RandomQuad(&random, 7), bits);
      Model expected, matched;
      for (const auto& t : model) {
        const Quad quad{std::get<0>(t), std::get<1>(t), std::get<2>(t),
                        std::get<3>(t)};
        if (MakePattern(quad, bits) == pattern) expected.insert(t);
      }
      std::size_t visits = 0;
      index.Match(pattern, [&](const Quad& quad) {
        matched.insert(AsTuple(quad));
        return ++visits > 0;
      });
      ASSERT_EQ(matched, expected) << bits;
      ASSERT_EQ(visits, expected.size()) << bits;
      ASSERT_GE(index.Estimate(pattern), expected.size()) << bits;
      const Quad any = RandomQuad(&random, 6);
      ASSERT_EQ(index.Contains(any), model.count(AsTuple(any)) == 1);
    }
  }
}

TEST(QuadIndex, EstimatesExactlyWhereNothingIsFiltered) {
  std::mt19937 random(3);
  std::vector<Quad> quads;
  Model model;
  for (int i = 0; i < 3000; ++i) {
    const Quad quad = RandomQuad(&random, 12);
    if (model.insert(AsTuple(quad)).second) quads.push_back(quad);
  }
  const QuadIndex index(quads);
  ASSERT_EQ(index.size(), quads.size());
  for (int bits = 0; bits < 16; ++bits) {
    const PatternPlan& plan = PatternPlans()[bits];
    if (plan.best.order != plan.other.order) continue;
    const Quad pattern = MakePattern(RandomQuad(&random, 12), bits);
    std::size_t matches = 0;
    index.Match(pattern, [&](const Quad&) { return ++matches > 0; });
    EXPECT_EQ(index.Estimate(pattern), matches) << bits;
  }
}

std::vector<Quad> NewQuads(std::mt19937* random, std::size_t n, Model* model) {
  std::vector<Quad> quads;
  while (quads.size() < n) {
    const Quad quad = RandomQuad(random, 400);
    if (model->insert(AsTuple(quad)).second) quads.push_back(quad);
  }
  return quads;
}

// Small batches, large ones, and batches so large that the trees are rebuilt:
// every order contains all quads, and an earlier copy none of them.
TEST(QuadIndex, InsertsManyAtOnceLikeOneByOne) {
  std::mt19937 random(4);
  QuadIndex index, slow;
  Model model;
  for (const std::size_t n : {10, 3000, 1200, 1, 9000, 999, 2000, 1000}) {
    const std::uint64_t edit = QuadTree::NewEdit();
    const QuadIndex before = index;
    const std::size_t size = before.size();
    const std::vector<Quad> quads = NewQuads(&random, n, &model);
    index.InsertAll(quads, edit);
    for (const Quad& quad : quads) slow.Insert(quad, edit);
    ASSERT_EQ(before.size(), size);
    ASSERT_EQ(index.size(), model.size());
    for (const int bits : {0, 8, 4, 2, 1}) {
      const Quad pattern = MakePattern(quads[0], bits);
      std::vector<Quad> found, expected;
      index.Match(pattern, [&](const Quad& quad) {
        found.push_back(quad);
        return true;
      });
      slow.Match(pattern, [&](const Quad& quad) {
        expected.push_back(quad);
        return true;
      });
      ASSERT_EQ(found, expected) << n << " " << bits;
    }
  }
}

TEST(QuadIndex, ListsGraphsAndUsedTermsLikeBruteForce) {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    Model model;
    const std::vector<Quad> quads = NewQuads(&random, random() % 200, &model);
    std::set<TermId> graphs;
    std::vector<bool> used(401);
    for (const Quad& q : quads) {
      graphs.insert(q.graph);
      for (const TermId id : {q.subject, q.predicate, q.object, q.graph}) {
        used[id] = true;
      }
    }
    const QuadIndex index(quads);
    EXPECT_EQ(index.Graphs(),
              std::vector<TermId>(graphs.begin(), graphs.end()));
    EXPECT_EQ(index.UsedTerms(401), used);
  }
}

TEST(QuadIndex, ASmallGraphIsNotSearchedThroughALargePredicate) {
  std::vector<Quad> quads;
  for (TermId i = 0; i < 5000; ++i) quads.push_back({10 + i, 1, 2, 3});
  quads.push_back({10, 1, 2, 4});
  const QuadIndex index(quads);
  EXPECT_EQ(index.Estimate({kNoTerm, 1, kNoTerm, 4}), 1u);
  EXPECT_EQ(index.Estimate({kNoTerm, 1, 2, 4}), 1u);
}

}  // namespace
}  // namespace kg_core
