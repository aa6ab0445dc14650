#include "kg_planner/k_best/staging.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "gtest/gtest.h"
#include "kg_planner/testing/random_trellis.h"

namespace kg_planner {
namespace {

// Node 0 has the larger immediate gain; only node 1 leads to the large reward.
Trellis Detour() {
  Trellis trellis;
  trellis.stages.resize(2);
  trellis.stages[0].nodes = {{5.0, {}}, {1.0, {}}};
  trellis.stages[0].seams = {{0, 0, 1.0, 0.0}, {0, 1, 1.0, 0.0}};
  trellis.stages[1].nodes = {{0.0, {}}, {10.0, {}}};
  trellis.stages[1].seams = {{0, 0, 0.0, 0.0}, {1, 1, 0.5, 0.0}};
  return trellis;
}

std::vector<bool> OfTheBest(const Trellis& trellis,
                            const PathMasks& masks = {}) {
  return FindStaging(trellis, masks,
                     FindKBest(trellis, masks, {1}).paths.at(0));
}

TEST(StagingTest, ASeamTakenForAPrizeBehindItIsStaging) {
  EXPECT_EQ(OfTheBest(Detour()), (std::vector<bool>{true, false}));
}

TEST(StagingTest, TheBestGainAtOnceIsNot) {
  Trellis trellis = Detour();
  trellis.stages[1].nodes[1].reward = 1.0;
  EXPECT_EQ(OfTheBest(trellis), (std::vector<bool>{false, false}));
}

TEST(StagingTest, EqualGainsAreNot) {
  Trellis trellis = Detour();
  trellis.stages[0].nodes[1].reward = 4.3;
  trellis.stages[0].seams[1].cost = 0.1 + 0.2;
  EXPECT_EQ(OfTheBest(trellis), (std::vector<bool>{false, false}));
}

TEST(StagingTest, WhatIsForbiddenIsNotComparedWith) {
  EXPECT_EQ(OfTheBest(Detour(), {{{0, 0}}, {}}),
            (std::vector<bool>{false, false}));
}

TEST(StagingTest, ATokenThatIsEarnedBringsNothingMore) {
  Trellis trellis = Detour();
  trellis.stages[0].nodes[1].tokens = {{3, 7.0}};
  trellis.stages[1].nodes.push_back({0.0, {{3, 20.0}}});
  trellis.stages[1].nodes.push_back({0.0, {{3, 9.0}}});
  trellis.stages[1].seams.push_back({1, 3, 0.0, 0.0});  // Gain 2, not 9.
  Path path;
  path.seams = {1, 1};
  EXPECT_EQ(FindStaging(trellis, {}, path), (std::vector<bool>{false, false}));
  trellis.stages[1].seams.push_back({1, 2, 0.0, 0.0});  // Gain 13.
  EXPECT_EQ(FindStaging(trellis, {}, path), (std::vector<bool>{false, true}));
}

TEST(StagingTest, StopsOnTheWayCount) {
  Trellis trellis = Detour();
  trellis.stages[0].seams.push_back({0, 1, 1.5, 0.0});
  trellis.stages[0].via = {{}, {}, {0}};
  EXPECT_EQ(OfTheBest(trellis), (std::vector<bool>{false, false}));
}

TEST(StagingTest, RefusesPathsThroughOtherTrellises) {
  const Trellis trellis = Detour();
  Path path;
  path.seams = {0};
  EXPECT_THROW(FindStaging(trellis, {}, path), std::invalid_argument);
  path.seams = {0, 1};
  EXPECT_THROW(FindStaging(trellis, {}, path), std::invalid_argument);
  path.seams = {0, 2};
  EXPECT_THROW(FindStaging(trellis, {}, path), std::invalid_argument);
  path.seams = {0, -1};
  EXPECT_THROW(FindStaging(trellis, {}, path), std::invalid_argument);
}

// A path has no staging seam exactly if it is the greedy path, which is built
// by hand here.
TEST(StagingTest, TheGreedyPathNeverStagesAndOthersDo) {
  RandomOptions options;
  options.missing = 0.0;
  RandomTrellis random(options, 42);
  int staging = 0;
  for (int i = 0; i < 1000; ++i) {
    const Trellis trellis = random.Make();
    const ExhaustiveSearch exhaustion(trellis, {});
    for (const Path& path : exhaustion.paths()) {
      bool greedy = true;
      int at = 0;
      for (std::size_t s = 0; s < path.seams.size(); ++s) {
        const Stage& stage = trellis.stages[s];
        const auto gain = [&](const Seam& seam) {
          return stage.nodes[seam.to].reward - seam.cost;
        };
        for (const Seam& seam : stage.seams) {
          greedy = greedy && (seam.from != at ||
                              gain(seam) <= gain(stage.seams[path.seams[s]]));
        }
        at = path.nodes[s];
      }
      const std::vector<bool> found = FindStaging(trellis, {}, path);
      const bool stages = std::count(found.begin(), found.end(), true) > 0;
      ASSERT_EQ(stages, !greedy) << "case " << i;
      staging += stages;
      if (path.nodes.size() > 3) break;  // One multi-stage path suffices.
    }
  }
  EXPECT_GT(staging, 300);
}

}  // namespace
}  // namespace kg_planner
