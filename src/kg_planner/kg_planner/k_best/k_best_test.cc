#include "kg_planner/k_best/k_best.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "gtest/gtest.h"
#include "kg_planner/k_best/path_enumerator.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/testing/random_trellis.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

constexpr double kTolerance = 1e-9;

void ExpectSame(const std::vector<Path>& found, const std::vector<Path>& all,
                int asked) {
  ASSERT_EQ(found.size(), std::min<std::size_t>(asked, all.size()));
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].nodes, all[i].nodes) << "rank " << i;
    EXPECT_NEAR(found[i].reward, all[i].reward, kTolerance);
    EXPECT_NEAR(found[i].cost, all[i].cost, kTolerance);
    EXPECT_DOUBLE_EQ(found[i].resource, all[i].resource);
    EXPECT_EQ(found[i].more_resources, all[i].more_resources);
    EXPECT_EQ(found[i].seams, all[i].seams);
  }
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Excess over each limit of the path of least use that keeps the other limits.
std::vector<double> AboveLimits(const Trellis& trellis,
                                const PathMasks& masks) {
  std::vector<double> above;
  bool any = false;
  for (std::size_t r = 0; r <= trellis.more_limits.size(); ++r) {
    Trellis open = trellis;
    double& limit = r == 0 ? open.resource_limit : open.more_limits[r - 1];
    const double lifted = limit;
    limit = kInfinity;
    above.push_back(kInfinity);
    if (!(lifted < kInfinity)) continue;
    const ExhaustiveSearch exhaustion(open, masks);
    for (const Path& path : exhaustion.paths()) {
      const double use = r == 0 ? path.resource : path.more_resources[r - 1];
      above.back() = std::min(above.back(), use - lifted);
      any = true;
    }
  }
  return any ? above : std::vector<double>();
}

void ExpectSameAbove(const std::vector<double>& a,
                     const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t r = 0; r < a.size(); ++r) {
    if (b[r] < kInfinity) {
      EXPECT_NEAR(a[r], b[r], kTolerance);
    } else {
      EXPECT_EQ(a[r], kInfinity);
    }
  }
}

// Number of times each case occurred, so that no check is vacuous.
struct CaseCounts {
  int none = 0;
  int ties = 0;
  int fewer = 0;
  int tokens_met_twice = 0;
  int stops = 0;        // The best path has a stop.
  int above_limit = 0;  // No path because of a single limit.
};

void Count(const Trellis& trellis, const std::vector<Path>& all, int asked,
           CaseCounts* seen) {
  seen->none += all.empty();
  seen->fewer += all.size() < static_cast<std::size_t>(asked);
  if (!all.empty()) {
    for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
      const auto& via = trellis.stages[s].via;
      if (via.empty() || via[all.front().seams[s]].empty()) continue;
      ++seen->stops;
      break;
    }
  }
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].score() == all[i - 1].score()) {
      ++seen->ties;
      break;
    }
  }
  for (const Path& path : all) {
    double plain = 0.0;
    for (std::size_t s = 0; s < path.nodes.size(); ++s) {
      const Node& node = trellis.stages[s].nodes[path.nodes[s]];
      plain += node.reward;
      for (const TokenReward& token : node.tokens) plain += token.reward;
    }
    if (plain > path.reward + 0.5) {
      ++seen->tokens_met_twice;
      break;
    }
  }
}

CaseCounts CompareWithExhaustion(const RandomOptions& options, unsigned seed,
                                 int cases) {
  RandomTrellis random(options, seed);
  CaseCounts seen;
  for (int i = 0; i < cases; ++i) {
    const Trellis trellis = random.Make();
    const PathMasks masks = random.MakeMasks(trellis);
    const ExhaustiveSearch exhaustion(trellis, masks);
    const int asked = random.Whole(1, 40);
    const KBest found = FindKBest(trellis, masks, {asked, 100000});
    EXPECT_TRUE(found.proven);
    ExpectSame(found.paths, exhaustion.paths(), asked);
    const double best = exhaustion.paths().empty()
                            ? -kInfinity
                            : exhaustion.paths().front().score();
    if (best > -kInfinity) {
      EXPECT_NEAR(found.bound, best, kTolerance);
    } else {
      EXPECT_EQ(found.bound, best);
    }
    if (exhaustion.paths().empty()) {
      ExpectSameAbove(found.above_limits, AboveLimits(trellis, masks));
    } else {
      EXPECT_TRUE(found.above_limits.empty());
    }
    seen.above_limit += !found.above_limits.empty();
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "case " << i;
      break;
    }
    Count(trellis, exhaustion.paths(), asked, &seen);
  }
  return seen;
}

TEST(KBestTest, EqualsExhaustionOnRandomTrellises) {
  const CaseCounts seen = CompareWithExhaustion({}, 42, 1000);
  EXPECT_GT(seen.none, 20);
  EXPECT_GT(seen.fewer, 100);
}

TEST(KBestTest, BreaksTiesByNodeNumbers) {
  RandomOptions options;
  options.whole_numbers = true;
  EXPECT_GT(CompareWithExhaustion(options, 43, 1000).ties, 500);
}

TEST(KBestTest, EarnsEveryTokenOnce) {
  RandomOptions options;
  options.tokens = true;
  EXPECT_GT(CompareWithExhaustion(options, 44, 1000).tokens_met_twice, 300);
  options.whole_numbers = true;
  EXPECT_GT(CompareWithExhaustion(options, 45, 1000).tokens_met_twice, 300);
}

TEST(KBestTest, KeepsTheResourceLimit) {
  RandomOptions options;
  options.limited = true;
  EXPECT_GT(CompareWithExhaustion(options, 46, 1000).none, 50);
  options.whole_numbers = true;
  EXPECT_GT(CompareWithExhaustion(options, 47, 1000).ties, 300);
}

TEST(KBestTest, EqualsExhaustionWithEverythingAtOnce) {
  RandomOptions options;
  options.tokens = options.limited = options.masked = true;
  CompareWithExhaustion(options, 48, 1000);
  options.whole_numbers = true;
  CompareWithExhaustion(options, 49, 1000);
}

// Every combination of tokens, limits, masks, stops and further resources, with
// real and integer values.
TEST(KBestTest, EqualsExhaustionWhateverIsCombined) {
  CaseCounts seen;
  for (int choice = 0; choice < 64; ++choice) {
    RandomOptions options;
    options.whole_numbers = choice & 1;
    options.tokens = choice & 2;
    options.limited = choice & 4;
    options.masked = choice & 8;
    options.stops = choice & 16;
    options.more_resources = choice & 32 ? 2 : 0;
    options.max_stages = 4;
    options.max_nodes = 4;
    SCOPED_TRACE(choice);
    const CaseCounts more = CompareWithExhaustion(options, 100 + choice, 60);
    if (HasFailure()) return;
    seen.none += more.none;
    seen.ties += more.ties;
    seen.tokens_met_twice += more.tokens_met_twice;
    seen.stops += more.stops;
    seen.above_limit += more.above_limit;
  }
  EXPECT_GT(seen.none, 300);
  EXPECT_GT(seen.ties, 400);
  EXPECT_GT(seen.tokens_met_twice, 800);
  EXPECT_GT(seen.stops, 500);
  EXPECT_GT(seen.above_limit, 200);
}

TEST(KBestTest, EarnsWhatItStopsFor) {
  RandomOptions options;
  options.stops = options.tokens = true;
  EXPECT_GT(CompareWithExhaustion(options, 54, 1000).stops, 500);
}

TEST(KBestTest, KeepsSeveralLimits) {
  RandomOptions options;
  options.limited = true;
  options.more_resources = 3;
  const CaseCounts seen = CompareWithExhaustion(options, 55, 1000);
  EXPECT_GT(seen.none, 100);
  EXPECT_GT(seen.above_limit, 100);
}

TEST(KBestTest, KeepsToTheMasks) {
  RandomOptions options;
  options.masked = true;
  options.missing = 0.0;
  EXPECT_GT(CompareWithExhaustion(options, 50, 1000).none, 20);
}

// Cheap seams use much of the resource: more paths than are enumerated before
// the resource is priced.
TEST(KBestTest, EqualsExhaustionWhenTheLimitIsTight) {
  RandomTrellis random({false, true, true, false, 0.0, 7, 6}, 51);
  int priced = 0;
  for (int i = 0; i < 300; ++i) {
    Trellis trellis = random.Make();
    trellis.resource_limit = 1.5 * static_cast<double>(trellis.stages.size());
    for (Stage& stage : trellis.stages) {
      for (Seam& seam : stage.seams) seam.cost = 6.0 - seam.resource;
    }
    const ExhaustiveSearch exhaustion(trellis, {});
    ExpectSame(FindKBest(trellis, {}, {20, 100000}).paths, exhaustion.paths(),
               20);
    priced += !FindKBest(trellis, {}, {20, 500}).proven;
  }
  EXPECT_GT(priced, 5);
}

Trellis Uniform(int stages, int nodes) {
  Trellis trellis;
  for (int s = 0; s < stages; ++s) {
    Stage& stage = trellis.stages.emplace_back();
    stage.nodes.resize(nodes);
    for (int u = 0; u < (s == 0 ? 1 : nodes); ++u) {
      for (int v = 0; v < nodes; ++v) stage.seams.push_back({u, v, 0.1, 1.0});
    }
  }
  return trellis;
}

TEST(KBestTest, AMillionMillionEqualPathsComeInOrderWithoutLookingAtThemAll) {
  const KBest found = FindKBest(Uniform(12, 10), {}, {25, 100});
  EXPECT_TRUE(found.proven);
  ASSERT_EQ(found.paths.size(), 25u);
  for (int i = 0; i < 25; ++i) {
    EXPECT_EQ(found.paths[i].nodes[11], i % 10);
    EXPECT_EQ(found.paths[i].nodes[10], i / 10);
    EXPECT_EQ(found.paths[i].nodes[9], 0);
  }
}

// 0.1 + 0.2 + 0.3 depends on the order of summation; ties must not.
TEST(KBestTest, RoundingDoesNotDecideTies) {
  Trellis trellis = Uniform(3, 3);
  const double costs[3] = {0.1, 0.2, 0.3};
  for (Stage& stage : trellis.stages) {
    for (Seam& seam : stage.seams) seam.cost = costs[seam.to];
  }
  const std::vector<std::vector<int>> permutations = {
      {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  std::vector<std::vector<int>> found;
  for (const Path& path : FindKBest(trellis, {}, {27, 1000}).paths) {
    if (std::count(permutations.begin(), permutations.end(), path.nodes) > 0) {
      found.push_back(path.nodes);
    }
  }
  EXPECT_EQ(found, permutations);
}

TEST(KBestTest, SaysWhenTheEnumerationLimitWasHit) {
  RandomTrellis random({false, false, true, false, 0.0, 6, 6}, 52);
  int hit = 0;
  for (int i = 0; i < 200; ++i) {
    Trellis trellis = random.Make();
    trellis.resource_limit = 1.5 * static_cast<double>(trellis.stages.size());
    const KBest found = FindKBest(trellis, {}, {5, 3});
    const std::vector<Path> all = ExhaustiveSearch(trellis, {}).paths();
    if (found.proven) ExpectSame(found.paths, all, 5);
    hit += !found.proven;
    for (const Path& path : found.paths) {
      EXPECT_LE(path.resource, trellis.resource_limit);
    }
    for (const Path& path : all) EXPECT_GE(found.bound, path.score());
  }
  EXPECT_GT(hit, 50);
}

// Three limits at once, each violated by cheap seams: all prices are needed,
// and more paths than are enumerated without them.
TEST(KBestTest, BoundsEveryAllowedPathHoweverFewItLooksAt) {
  RandomTrellis random({false, true, true, false, 0.0, 8, 4, false, 2}, 56);
  int unproven = 0;
  int found_one = 0;
  for (int i = 0; i < 240; ++i) {
    Trellis trellis = random.Make();
    if (trellis.stages.size() < 7) continue;  // Too few paths.
    const double limit = 2.3 * static_cast<double>(trellis.stages.size());
    trellis.resource_limit = limit;
    trellis.more_limits = {limit, limit};
    for (Stage& stage : trellis.stages) {
      for (std::size_t s = 0; s < stage.seams.size(); ++s) {
        stage.seams[s].cost =
            6.0 - (stage.seams[s].resource + stage.more_resources[0][s] +
                   stage.more_resources[1][s]) /
                      3.0;
      }
    }
    const std::vector<Path> all = ExhaustiveSearch(trellis, {}).paths();
    const KBest found = FindKBest(trellis, {}, {20, 510});
    unproven += !found.proven;
    found_one += !found.proven && !found.paths.empty();
    for (const Path& path : all) EXPECT_GE(found.bound, path.score());
    if (found.proven) ExpectSame(found.paths, all, 20);
    for (const Path& path : found.paths) {
      EXPECT_LE(path.resource, limit);
      EXPECT_LE(path.more_resources[0], limit);
      EXPECT_LE(path.more_resources[1], limit);
    }
  }
  EXPECT_GT(unproven, 3);
  EXPECT_GT(found_one, 3);
}

TEST(KBestTest, AllPathsFoundIsProvenWhateverTheLimit) {
  const KBest found = FindKBest(Uniform(1, 3), {}, {10, 3});
  EXPECT_EQ(found.paths.size(), 3u);
  EXPECT_TRUE(found.proven);
}

TEST(KBestTest, FindsNoPathIfThereIsNone) {
  EXPECT_TRUE(FindKBest({}, {}, {5, 100}).paths.empty());
  Trellis empty_stage = Uniform(3, 2);
  empty_stage.stages[1] = Stage();
  empty_stage.stages[2].seams.clear();
  EXPECT_TRUE(FindKBest(empty_stage, {}, {5, 100}).paths.empty());
  EXPECT_TRUE(FindKBest(Uniform(3, 2), {}, {0, 100}).paths.empty());
  EXPECT_TRUE(FindKBest(Uniform(3, 2), {}, {-1, 100}).paths.empty());
  EXPECT_NEAR(FindKBest(Uniform(3, 2), {}, {0, 100}).bound, -0.3, kTolerance);
  Trellis too_far = Uniform(3, 2);
  too_far.resource_limit = 2.9;
  EXPECT_TRUE(FindKBest(too_far, {}, {5, 100}).paths.empty());
  too_far.resource_limit = -1.0;
  EXPECT_TRUE(FindKBest(too_far, {}, {5, 100}).paths.empty());
  too_far.resource_limit = -std::numeric_limits<double>::infinity();
  EXPECT_TRUE(FindKBest(too_far, {}, {5, 100}).paths.empty());
}

TEST(KBestTest, AnExactlyUsedUpResourceIsAllowed) {
  Trellis trellis = Uniform(3, 2);
  trellis.resource_limit = 3.0;
  EXPECT_EQ(FindKBest(trellis, {}, {100, 1000}).paths.size(), 8u);
}

TEST(KBestTest, ATokenNamedTwiceAtANodeIsEarnedOnce) {
  Trellis trellis = Uniform(1, 1);
  trellis.stages[0].nodes[0].tokens = {{7, 2.0}, {7, 5.0}, {7, 3.0}};
  EXPECT_DOUBLE_EQ(FindKBest(trellis, {}, {1, 10}).paths[0].reward, 5.0);
}

// A token offered in every stage: the plain bound is seven times too high, and
// 5^7 paths lie between it and the optimum.
TEST(KBestTest, TokensOnOfferInEveryStageAreFoundOutWithoutEnumeration) {
  Trellis trellis = Uniform(7, 10);
  for (Stage& stage : trellis.stages) {
    for (int v = 0; v < 10; ++v) {
      stage.nodes[v].reward = 0.01 * v;
      if (v < 5) stage.nodes[v].tokens = {{v % 2, 100.0}};
    }
  }
  const KBest found = FindKBest(trellis, {}, {3, 100});
  EXPECT_TRUE(found.proven);
  ASSERT_EQ(found.paths.size(), 3u);
  EXPECT_NEAR(found.paths[0].reward, 200.0 + 0.04 + 0.03 + 5 * 0.09, 1e-9);
}

TEST(KBestTest, RefusesMasksOfWhatIsNotThere) {
  const Trellis trellis = Uniform(2, 2);
  EXPECT_THROW(FindKBest(trellis, {{{2, 0}}, {}}, {}), std::invalid_argument);
  EXPECT_THROW(FindKBest(trellis, {{{0, 2}}, {}}, {}), std::invalid_argument);
  EXPECT_THROW(FindKBest(trellis, {{{-1, 0}}, {}}, {}), std::invalid_argument);
  EXPECT_THROW(FindKBest(trellis, {{}, {{0, 1, 0}}}, {}),
               std::invalid_argument);
  EXPECT_THROW(FindKBest(trellis, {{}, {{1, 0, 5}}}, {}),
               std::invalid_argument);
}

TEST(KBestTest, RefusesASeamMaskViaWhatIsNotThere) {
  const Trellis trellis = Uniform(2, 2);
  EXPECT_THROW(FindKBest(trellis, {{}, {{1, 0, 1, {2}}}}, {}),
               std::invalid_argument);
}

TEST(KBestTest, SaysByHowMuchTheThriftiestPathIsAboveTheLimit) {
  Trellis trellis = Uniform(3, 2);
  trellis.resource_limit = 2.25;
  EXPECT_EQ(FindKBest(trellis, {}, {5, 100}).above_limits,
            std::vector<double>{0.75});
  for (Stage& stage : trellis.stages) {
    stage.more_resources = {std::vector<double>(stage.seams.size(), 2.0)};
  }
  trellis.more_limits = {5.0};
  EXPECT_TRUE(FindKBest(trellis, {}, {5, 100}).above_limits.empty());
  trellis.resource_limit = 3.0;
  EXPECT_EQ(FindKBest(trellis, {}, {5, 100}).above_limits,
            (std::vector<double>{kInfinity, 1.0}));
}

TEST(KBestTest, ThrowsAsCheckDoes) {
  Trellis trellis = Uniform(2, 2);
  trellis.stages[1].seams[2].cost = -1.0;
  EXPECT_THROW(FindKBest(trellis, {}, {}), std::invalid_argument);
}

TEST(PathEnumeratorTest, YieldsEveryPathOnceInOrderOfItsBound) {
  RandomTrellis random({true, true, false, false, 0.2, 5, 4, true, 1}, 53);
  for (int i = 0; i < 300; ++i) {
    const Trellis trellis = random.Make();
    const ScoreGrid grid(1000.0);
    const SearchTrellis search =
        ToSearch(trellis, CheckTrellis(trellis).sorted, {}, grid);
    PathEnumerator enumerator(search, grid, {0.5, 0.25});
    std::vector<std::vector<int>> found;
    double last = kInfinity;
    while (const auto next = enumerator.Next()) {
      EXPECT_LE(next->bound, last);
      last = next->bound;
      found.push_back(next->seams);
    }
    EXPECT_FALSE(enumerator.Next());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::unique(found.begin(), found.end()), found.end());
    EXPECT_EQ(found.size(), ExhaustiveSearch(trellis, {}).paths().size());
  }
}

}  // namespace
}  // namespace kg_planner
