#include "kg_planner/k_best/k_best_memory.h"

#include <limits>
#include <stdexcept>
#include <vector>

#include "gtest/gtest.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_planner/testing/random_trellis.h"

namespace kg_planner {
namespace {

void ExpectIdentical(const KBest& a, const KBest& b) {
  EXPECT_EQ(a.proven, b.proven);
  EXPECT_EQ(a.bound, b.bound);
  EXPECT_EQ(a.above_limits, b.above_limits);
  ASSERT_EQ(a.paths.size(), b.paths.size());
  for (std::size_t i = 0; i < a.paths.size(); ++i) {
    EXPECT_EQ(a.paths[i].seams, b.paths[i].seams);
    EXPECT_EQ(a.paths[i].nodes, b.paths[i].nodes);
    EXPECT_EQ(a.paths[i].reward, b.paths[i].reward);
    EXPECT_EQ(a.paths[i].cost, b.paths[i].cost);
    EXPECT_EQ(a.paths[i].resource, b.paths[i].resource);
    EXPECT_EQ(a.paths[i].more_resources, b.paths[i].more_resources);
  }
}

// Changes one number of one stage; returns the stage's index.
std::size_t Change(RandomTrellis* random, Trellis* trellis) {
  const std::size_t s = static_cast<std::size_t>(
      random->Whole(0, static_cast<int>(trellis->stages.size()) - 1));
  Stage& stage = trellis->stages[s];
  const double number = random->Whole(0, 300) / 100.0;
  const int kind = random->Whole(0, 3);
  if (kind <= 1 && !stage.nodes.empty()) {
    stage.nodes[random->Whole(0, static_cast<int>(stage.nodes.size()) - 1)]
        .reward = number;
  }
  if (kind >= 2 && !stage.seams.empty()) {
    Seam& seam =
        stage.seams[random->Whole(0, static_cast<int>(stage.seams.size()) - 1)];
    (kind == 2 ? seam.cost : seam.resource) = number;
  }
  return s;
}

struct ReuseCounts {
  int stages = 0;
  int of = 0;
};

ReuseCounts CompareSequences(const RandomOptions& options, unsigned seed,
                             int sequences) {
  RandomTrellis random(options, seed);
  ReuseCounts reused;
  for (int i = 0; i < sequences; ++i) {
    Trellis trellis = random.Make();
    const PathMasks masks = random.MakeMasks(trellis);
    KBestMemory memory;
    for (int change = 0; change < 8; ++change) {
      const KBestOptions k_best{random.Whole(1, 30), 100000};
      ExpectIdentical(FindKBest(trellis, masks, k_best, &memory),
                      FindKBest(trellis, masks, k_best));
      if (testing::Test::HasFailure()) {
        ADD_FAILURE() << "sequence " << i << ", change " << change;
        return reused;
      }
      reused.stages += memory.reused_stages();
      reused.of += static_cast<int>(trellis.stages.size());
      Change(&random, &trellis);
    }
  }
  return reused;
}

TEST(KBestMemoryTest, NeverChangesTheResult) {
  for (int choice = 0; choice < 32; ++choice) {
    RandomOptions options;
    options.whole_numbers = choice & 1;
    options.tokens = choice & 2;
    options.limited = choice & 4;
    options.masked = choice & 8;
    options.stops = choice & 16;
    options.more_resources = choice & 4 ? 1 : 0;
    SCOPED_TRACE(choice);
    const ReuseCounts reused = CompareSequences(options, 200 + choice, 40);
    if (HasFailure()) return;
    EXPECT_GT(reused.stages, reused.of / 10);
  }
}

// Rewards and costs far below those of another stage, so that the grid does not
// change.
TEST(KBestMemoryTest, ReusesExactlyTheStagesBehindTheChange) {
  RandomOptions options;
  options.missing = 0.0;
  RandomTrellis random(options, 43);
  int behind = 0;
  for (int i = 0; i < 300; ++i) {
    Trellis trellis = random.Make();
    trellis.stages.push_back(Stage());
    trellis.stages.back().nodes = {{1500.0, {}}};
    const int last = static_cast<int>(
        trellis.stages[trellis.stages.size() - 2].nodes.size());
    for (int u = 0; u < last; ++u) {
      trellis.stages.back().seams.push_back({u, 0, 0.0, 0.0});
    }
    KBestMemory memory;
    if (FindKBest(trellis, {}, {20}, &memory).paths.empty()) continue;
    EXPECT_EQ(memory.reused_stages(), 0);
    FindKBest(trellis, {}, {20}, &memory);
    EXPECT_EQ(memory.reused_stages(), static_cast<int>(trellis.stages.size()));
    const std::size_t s = static_cast<std::size_t>(
        random.Whole(0, static_cast<int>(trellis.stages.size()) - 2));
    if (trellis.stages[s].seams.empty()) continue;
    trellis.stages[s].seams.back().cost += 0.25;
    FindKBest(trellis, {}, {20}, &memory);
    EXPECT_EQ(memory.reused_stages(),
              static_cast<int>(trellis.stages.size() - 1 - s));
    ++behind;
  }
  EXPECT_GT(behind, 200);
}

// The first stage is removed: the rest is unchanged, but starts from one node.
TEST(KBestMemoryTest, KeepsTheEndWhenStagesAreOver) {
  RandomOptions options;
  options.missing = 0.0;
  options.whole_numbers = true;
  RandomTrellis random(options, 44);
  int reused = 0;
  for (int i = 0; i < 300; ++i) {
    Trellis trellis = random.Make();
    KBestMemory memory;
    FindKBest(trellis, {}, {20}, &memory);
    while (trellis.stages.size() > 1) {
      trellis.stages.erase(trellis.stages.begin());
      auto& seams = trellis.stages.front().seams;
      std::vector<Seam> first;
      for (const Seam& seam : seams) {
        if (seam.from == 0) first.push_back(seam);
      }
      seams = first;
      ExpectIdentical(FindKBest(trellis, {}, {20}, &memory),
                      FindKBest(trellis, {}, {20}));
      reused += memory.reused_stages();
    }
  }
  EXPECT_GT(reused, 300);
}

TEST(KBestMemoryTest, SurvivesATrellisThatIsRefused) {
  RandomTrellis random({}, 45);
  const Trellis trellis = random.Make();
  KBestMemory memory;
  FindKBest(trellis, {}, {5}, &memory);
  Trellis wrong = trellis;
  wrong.resource_limit = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FindKBest(wrong, {}, {5}, &memory), std::invalid_argument);
  ExpectIdentical(FindKBest(trellis, {}, {5}, &memory),
                  FindKBest(trellis, {}, {5}));
  EXPECT_EQ(memory.reused_stages(), static_cast<int>(trellis.stages.size()));
}

}  // namespace
}  // namespace kg_planner
