#include "kg_planner/k_best/diverse_paths.h"

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "gtest/gtest.h"
#include "kg_planner/k_best/limited_search.h"
#include "kg_planner/k_best/max_marginals.h"
#include "kg_planner/testing/random_trellis.h"

namespace kg_planner {
namespace {

constexpr double kTolerance = 1e-9;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

int Difference(const Path& a, const Path& b) {
  int stages = 0;
  for (std::size_t s = 0; s < a.nodes.size(); ++s) {
    stages += a.nodes[s] != b.nodes[s];
  }
  return stages;
}

bool DiffersFromAll(const std::vector<Path>& taken, const Path& path,
                    int minimum_difference) {
  return std::all_of(taken.begin(), taken.end(), [&](const Path& other) {
    return Difference(other, path) >= minimum_difference;
  });
}

// Direct implementation of the definition: `all` are the allowed paths, best
// first.
std::vector<Path> DiverseByExhaustion(const Trellis& trellis,
                                      const std::vector<Path>& all,
                                      const DiverseOptions& options) {
  std::vector<Path> through;
  for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
    for (std::size_t v = 0; v < trellis.stages[s].nodes.size(); ++v) {
      const auto best =
          std::find_if(all.begin(), all.end(), [&](const Path& path) {
            return path.nodes[s] == static_cast<int>(v);
          });
      if (best != all.end()) through.push_back(*best);
    }
  }
  std::stable_sort(
      through.begin(), through.end(),
      [](const Path& a, const Path& b) { return a.score() > b.score(); });
  std::vector<Path> taken;
  for (const Path& path : through) {
    if (static_cast<int>(taken.size()) < options.paths &&
        DiffersFromAll(taken, path, options.minimum_difference)) {
      taken.push_back(path);
    }
  }
  return taken;
}

void ExpectSame(const std::vector<Path>& a, const std::vector<Path>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].seams, b[i].seams) << "path " << i;
    EXPECT_EQ(a[i].nodes, b[i].nodes);
    EXPECT_NEAR(a[i].score(), b[i].score(), kTolerance);
  }
}

struct PathCounts {
  int several = 0;   // Paths.
  int rejected = 0;  // Rejected as too similar.
};

PathCounts CompareWithExhaustion(const RandomOptions& random_options,
                                 unsigned seed, int cases) {
  RandomTrellis random(random_options, seed);
  PathCounts seen;
  for (int i = 0; i < cases; ++i) {
    const Trellis trellis = random.Make();
    const PathMasks masks = random.MakeMasks(trellis);
    const ExhaustiveSearch exhaustion(trellis, masks);
    DiverseOptions options{random.Whole(1, 12), random.Whole(1, 4)};
    options.detours = false;
    const KBest found = FindDiverse(trellis, masks, options);
    const std::vector<Path> expected =
        DiverseByExhaustion(trellis, exhaustion.paths(), options);
    EXPECT_TRUE(found.proven);
    ExpectSame(found.paths, expected);
    if (!expected.empty()) {
      EXPECT_NEAR(found.bound, expected.front().score(), kTolerance);
    }
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "case " << i;
      break;
    }
    seen.several += expected.size() > 1;
    const DiverseOptions nearer{options.paths, 1};
    seen.rejected +=
        DiverseByExhaustion(trellis, exhaustion.paths(), nearer).size() >
        expected.size();
  }
  return seen;
}

TEST(DiversePathsTest, AreTheBestThroughEveryNodeThatDifferEnough) {
  const PathCounts seen = CompareWithExhaustion({}, 42, 1000);
  EXPECT_GT(seen.several, 300);
  EXPECT_GT(seen.rejected, 300);
}

TEST(DiversePathsTest, BreakTiesAsTheKBestDo) {
  RandomOptions options;
  options.whole_numbers = true;
  EXPECT_GT(CompareWithExhaustion(options, 43, 1000).several, 300);
}

TEST(DiversePathsTest, EarnEveryTokenOnceAndKeepToMasksAndStops) {
  for (int choice = 0; choice < 16; ++choice) {
    RandomOptions options;
    options.whole_numbers = choice & 1;
    options.tokens = choice & 2;
    options.masked = choice & 4;
    options.stops = choice & 8;
    options.more_resources = choice & 2 ? 1 : 0;
    SCOPED_TRACE(choice);
    CompareWithExhaustion(options, 50 + choice, 200);
    if (HasFailure()) return;
  }
}

// Within limits: the best path first, all allowed, diverse and sorted; proven
// results equal the definition.
TEST(DiversePathsTest, KeepTheLimitsAndSayWhatIsProven) {
  RandomOptions random_options;
  random_options.limited = random_options.tokens = random_options.stops = true;
  random_options.more_resources = 1;
  RandomTrellis random(random_options, 70);
  int proven = 0;
  int unproven = 0;
  for (int i = 0; i < 1000; ++i) {
    const Trellis trellis = random.Make();
    const ExhaustiveSearch exhaustion(trellis, {});
    const std::vector<Path>& all = exhaustion.paths();
    DiverseOptions options{random.Whole(1, 8), random.Whole(1, 3)};
    options.detours = i % 2 == 0;
    const KBest found = FindDiverse(trellis, {}, options);
    ASSERT_EQ(found.paths.empty(), all.empty()) << "case " << i;
    if (all.empty()) continue;
    EXPECT_EQ(found.paths.front().seams, all.front().seams);
    for (std::size_t k = 0; k < found.paths.size(); ++k) {
      const Path& path = found.paths[k];
      EXPECT_LE(path.resource, trellis.resource_limit);
      EXPECT_LE(path.more_resources[0], trellis.more_limits[0]);
      const std::vector<Path> before(found.paths.begin(),
                                     found.paths.begin() + k);
      EXPECT_TRUE(DiffersFromAll(before, path, options.minimum_difference));
      const double max_value = k == 0 ? found.bound : before.back().score();
      EXPECT_LE(path.score(), max_value + kTolerance);
    }
    if (found.proven && !options.detours) {
      ExpectSame(found.paths, DiverseByExhaustion(trellis, all, options));
    }
    if (HasFailure()) FAIL() << "case " << i;
    ++(found.proven ? proven : unproven);
  }
  EXPECT_GT(proven, 200);
  EXPECT_GT(unproven, 50);
}

Trellis Dense(int stages, int nodes, unsigned seed) {
  std::mt19937 prng(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Trellis trellis;
  for (int s = 0; s < stages; ++s) {
    Stage& stage = trellis.stages.emplace_back();
    stage.nodes.resize(nodes);
    for (Node& node : stage.nodes) node.reward = share(prng);
    for (int u = 0; u < (s == 0 ? 1 : nodes); ++u) {
      for (int v = 0; v < nodes; ++v) {
        stage.seams.push_back({u, v, 0.5 * share(prng), share(prng)});
      }
    }
  }
  return trellis;
}

TEST(DiversePathsTest, DetoursFillUpWithPathsThatDifferAndAreGoodEnough) {
  for (const double limit : {kNoLimit, 15.0}) {
    Trellis trellis = Dense(40, 30, 73);
    trellis.resource_limit = limit;
    DiverseOptions options{20, 10, 0.97};
    const std::vector<Path> paths = FindDiverse(trellis, {}, options).paths;
    EXPECT_GE(paths.size(), 8u);
    EXPECT_EQ(paths.front().nodes,
              FindKBest(trellis, {}, {1}).paths.front().nodes);
    for (std::size_t i = 1; i < paths.size(); ++i) {
      const std::vector<Path> before(paths.begin(), paths.begin() + i);
      EXPECT_TRUE(DiffersFromAll(before, paths[i], 10));
      EXPECT_LE(paths[i].score(), before.back().score() + kTolerance);
      EXPECT_GE(paths[i].score(), 0.97 * paths.front().score());
      EXPECT_LE(paths[i].resource, limit);
    }
    options.detours = false;
    EXPECT_LT(FindDiverse(trellis, {}, options).paths.size(), paths.size());
  }
}

TEST(DiversePathsTest, AreTheSameEveryTime) {
  const Trellis trellis = Dense(30, 20, 74);
  const DiverseOptions options{10, 8};
  ExpectSame(FindDiverse(trellis, {}, options).paths,
             FindDiverse(trellis, {}, options).paths);
}

TEST(DiversePathsTest, SayByHowMuchALimitIsMissed) {
  Trellis trellis;
  trellis.stages.resize(1);
  trellis.stages[0].nodes.resize(1);
  trellis.stages[0].seams = {{0, 0, 0.0, 5.0}};
  trellis.resource_limit = 3.0;
  const KBest found = FindDiverse(trellis, {}, {});
  EXPECT_TRUE(found.paths.empty());
  EXPECT_EQ(found.above_limits, std::vector<double>{2.0});
}

TEST(DiversePathsTest, OfAnEmptyTrellisAreNone) {
  EXPECT_TRUE(FindDiverse({}, {}, {}).paths.empty());
  Trellis trellis = RandomTrellis({}, 71).Make();
  EXPECT_TRUE(FindDiverse(trellis, {}, {0, 1}).paths.empty());
  trellis.stages[0].seams[0].cost = -1.0;
  EXPECT_THROW(FindDiverse(trellis, {}, {}), std::invalid_argument);
}

TEST(MaxMarginalsTest, AreTheBestScoresThroughEveryNode) {
  RandomOptions options;
  options.tokens = options.stops = true;
  RandomTrellis random(options, 72);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const Trellis trellis = random.Make();
    const LimitedSearch limited = MakeSearch(trellis, {});
    const MaxMarginals marginals(limited.search, limited.grid, {});
    const ExhaustiveSearch exhaustion(trellis, {});
    for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
      std::vector<double> best(trellis.stages[s].nodes.size(), -1e300);
      std::vector<double> found = best;
      for (const Path& path : exhaustion.paths()) {
        best[path.nodes[s]] = std::max(best[path.nodes[s]], path.score());
      }
      const SearchStage& stage = limited.search.stages[s];
      for (int v = 0; v < stage.nodes; ++v) {
        double& value = found[stage.OriginNode(v)];
        value = std::max(value, marginals.Score(s, v));
      }
      for (std::size_t v = 0; v < best.size(); ++v) {
        EXPECT_NEAR(found[v], best[v], kTolerance);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 5000);
}

}  // namespace
}  // namespace kg_planner
