#include "kg_core/rdf/quad_tree.h"

#include <algorithm>
#include <random>
#include <set>

#include "gtest/gtest.h"

namespace kg_core {
namespace {

using Model = std::set<QuadKey>;
constexpr QuadKey kLast = {~0ull, ~0ull};

std::vector<QuadKey> CollectKeys(const QuadTree& tree,
                                 const QuadKey& first = {},
                                 const QuadKey& last = kLast) {
  std::vector<QuadKey> keys;
  tree.Scan(first, last, [&](const QuadKey& key) {
    keys.push_back(key);
    return true;
  });
  return keys;
}

void ExpectEqual(const QuadTree& tree, const Model& model) {
  ASSERT_EQ(tree.size(), model.size());
  ASSERT_EQ(CollectKeys(tree),
            std::vector<QuadKey>(model.begin(), model.end()));
}

QuadKey RandomKey(std::mt19937_64* random, int range) {
  return {(*random)() % range, (*random)() % range};
}

TEST(QuadTree, EveryCopyStaysAsItWas) {
  std::mt19937_64 random(1);
  for (const int range : {4, 60, 3000}) {
    QuadTree tree;
    Model model;
    std::vector<std::pair<QuadTree, Model>> held;
    for (int round = 0; round < 30; ++round) {
      const std::uint64_t edit = QuadTree::NewEdit();
      const unsigned erase_share = random() % 10;
      for (int i = 0; i < 300; ++i) {
        const QuadKey key = RandomKey(&random, range);
        if (random() % 10 < erase_share) {
          ASSERT_EQ(tree.Erase(key, edit), model.erase(key) == 1);
        } else {
          ASSERT_EQ(tree.Insert(key, edit), model.insert(key).second);
        }
      }
      held.emplace_back(tree, model);
    }
    for (const auto& [copy, was] : held) ExpectEqual(copy, was);
  }
}

TEST(QuadTree, EmptiesAndFillsAgain) {
  QuadTree tree;
  const std::uint64_t edit = QuadTree::NewEdit();
  for (int round = 0; round < 3; ++round) {
    for (std::uint64_t i = 0; i < 5000; ++i) tree.Insert({i % 7, i}, edit);
    EXPECT_EQ(tree.size(), 5000u);
    for (std::uint64_t i = 0; i < 5000; ++i) {
      ASSERT_TRUE(tree.Erase({i % 7, i}, edit));
    }
    EXPECT_EQ(tree.size(), 0u);
    EXPECT_TRUE(CollectKeys(tree).empty());
    EXPECT_FALSE(tree.Contains({0, 0}));
  }
}

TEST(QuadTree, CountsAndScansEveryRange) {
  std::mt19937_64 random(2);
  QuadTree tree;
  Model model;
  for (int i = 0; i < 4000; ++i) {
    const QuadKey key = RandomKey(&random, 80);
    tree.Insert(key, QuadTree::NewEdit());
    model.insert(key);
  }
  for (int i = 0; i < 2000; ++i) {
    const QuadKey first = RandomKey(&random, 90);
    const QuadKey last = RandomKey(&random, 90);
    std::vector<QuadKey> expected;
    for (const QuadKey& key : model) {
      if (!(key < first) && !(last < key)) expected.push_back(key);
    }
    ASSERT_EQ(tree.CountBetween(first, last), expected.size());
    ASSERT_EQ(CollectKeys(tree, first, last), expected);
  }
}

TEST(QuadTree, GrowsFromSortedKeysOfAnyNumber) {
  for (const int count : {0, 1, 55, 56, 57, 63, 3136, 3137, 10000}) {
    Model model;
    for (int i = 0; i < count; ++i) model.insert({i / 3 + 0ull, i * 2ull});
    QuadTree tree =
        QuadTree::FromSorted(std::vector<QuadKey>(model.begin(), model.end()));
    ExpectEqual(tree, model);
    const QuadTree before = tree;
    const Model was = model;
    const std::uint64_t edit = QuadTree::NewEdit();
    for (std::uint64_t i = 0; i < 200; ++i) {
      tree.Insert({i, 1}, edit);
      model.insert({i, 1});
    }
    ExpectEqual(tree, model);
    ExpectEqual(before, was);
  }
}

TEST(QuadTree, StopsWhenTheVisitorHasEnough) {
  QuadTree tree;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    tree.Insert({i, 0}, QuadTree::NewEdit());
  }
  for (const int wanted : {1, 2, 64, 65, 999}) {
    int seen = 0;
    tree.Scan({}, kLast, [&](const QuadKey&) { return ++seen < wanted; });
    EXPECT_EQ(seen, wanted);
  }
}

}  // namespace
}  // namespace kg_core
