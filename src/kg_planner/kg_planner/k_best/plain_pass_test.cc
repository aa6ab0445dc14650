#include "kg_planner/k_best/plain_pass.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "gtest/gtest.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Rows of up to 23 seams, complete or with gaps, and nodes without seams.
Trellis RandomRows(std::mt19937* prng) {
  std::uniform_real_distribution<double> number(0.0, 9.0);
  const auto whole = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(*prng);
  };
  Trellis trellis;
  trellis.stages.resize(3);
  int before = 1;
  for (Stage& stage : trellis.stages) {
    stage.nodes.resize(whole(1, 23));
    for (Node& node : stage.nodes) node.reward = number(*prng) - 4.0;
    for (int u = 0; u < before; ++u) {
      const int missing = std::max(0, whole(-3, 3));
      for (int v = 0; v < static_cast<int>(stage.nodes.size()); ++v) {
        if (whole(0, 3) >= missing) {
          stage.seams.push_back({u, v, number(*prng), number(*prng)});
        }
      }
    }
    before = static_cast<int>(stage.nodes.size());
  }
  return trellis;
}

std::vector<double> BestBefore(const Stage& stage, const ScoreGrid& grid,
                               int nodes, const std::vector<double>& behind) {
  std::vector<double> best(nodes, kNone);
  for (const Seam& seam : stage.seams) {
    best[seam.from] =
        std::max(best[seam.from], behind[seam.to] +
                                      grid.Round(stage.nodes[seam.to].reward) -
                                      grid.Round(seam.cost));
  }
  return best;
}

void ExpectRight(const Trellis& trellis, const PlainPass& pass) {
  EXPECT_EQ(pass.largest_total, CheckTrellis(trellis).largest_total);
  const ScoreGrid grid(pass.largest_total);
  ASSERT_EQ(pass.levels.size(), trellis.stages.size() + 1);
  std::vector<double> best(trellis.stages.back().nodes.size(), 0.0);
  EXPECT_EQ(pass.levels.back().best, best);
  for (std::size_t s = trellis.stages.size(); s-- > 0;) {
    const Stage& stage = trellis.stages[s];
    const int nodes = NodesBefore(trellis, s);
    best = BestBefore(stage, grid, nodes, best);
    EXPECT_EQ(pass.levels[s].best, best);
    const std::vector<int>& first = pass.levels[s].first_seam;
    ASSERT_EQ(first.size(), nodes + 1u);
    EXPECT_EQ(first.back(), static_cast<int>(stage.seams.size()));
    for (int u = 0; u < nodes; ++u) {
      for (int i = first[u]; i < first[u + 1]; ++i) {
        EXPECT_EQ(stage.seams[i].from, u);
      }
    }
  }
}

TEST(PlainPassTest, EqualsThePlainRecursion) {
  std::mt19937 prng(42);
  for (int i = 0; i < 1000; ++i) {
    const Trellis trellis = RandomRows(&prng);
    const auto pass = PassPlain(trellis);
    ASSERT_TRUE(pass);
    ExpectRight(trellis, *pass);
    if (HasFailure()) FAIL() << "case " << i;
  }
}

// Every kind of invalid seam, at any position of a row.
TEST(PlainPassTest, PassesNothingThatIsNotSound) {
  const double infinity = std::numeric_limits<double>::infinity();
  const int far = std::numeric_limits<int>::max();
  const std::vector<std::function<void(Seam*)>> mistakes = {
      [](Seam* seam) { seam->cost = -1.0; },
      [](Seam* seam) { seam->cost = kNan; },
      [](Seam* seam) { seam->cost = -kNan; },
      [=](Seam* seam) { seam->cost = infinity; },
      [](Seam* seam) { seam->resource = -1e-300; },
      [](Seam* seam) { seam->resource = kNan; },
      [=](Seam* seam) { seam->resource = infinity; },
      [](Seam* seam) { seam->from += 1000; },
      [](Seam* seam) { seam->from = -1; },
      [=](Seam* seam) { seam->from = far; },
      [](Seam* seam) { seam->to += 1000; },
      [](Seam* seam) { seam->to = -1; },
      [=](Seam* seam) { seam->to = far; },
      [=](Seam* seam) { seam->to = -far - 1; }};
  std::mt19937 prng(43);
  for (int i = 0; i < 300; ++i) {
    const Trellis sound = RandomRows(&prng);
    for (std::size_t m = 0; m < mistakes.size(); ++m) {
      Trellis trellis = sound;
      Stage& stage = trellis.stages[prng() % trellis.stages.size()];
      if (stage.seams.empty()) continue;
      mistakes[m](&stage.seams[prng() % stage.seams.size()]);
      EXPECT_FALSE(PassPlain(trellis)) << "case " << i << ", mistake " << m;
      Trellis exchanged = sound;
      auto& seams = exchanged.stages[1].seams;
      if (seams.size() < 2) continue;
      const std::size_t place = prng() % (seams.size() - 1);
      std::swap(seams[place], seams[place + 1]);
      EXPECT_FALSE(PassPlain(exchanged));
      seams[place] = seams[place + 1];
      EXPECT_FALSE(PassPlain(exchanged));
    }
  }
}

// One row longer than the sample from which the scale is guessed.
TEST(PlainPassTest, AWrongGuessOfTheScaleIsMadeGood) {
  Trellis trellis;
  trellis.stages.resize(1);
  trellis.stages[0].nodes.resize(2000);
  for (int v = 0; v < 2000; ++v) {
    trellis.stages[0].seams.push_back({0, v, v < 1900 ? 0.1 : 1e6, 0.0});
  }
  const auto pass = PassPlain(trellis);
  ASSERT_TRUE(pass);
  ExpectRight(trellis, *pass);
}

TEST(PlainPassTest, LeavesWhatIsNotPlainToOthers) {
  std::mt19937 prng(44);
  const Trellis plain = RandomRows(&prng);
  Trellis other = plain;
  other.resource_limit = 5.0;
  EXPECT_FALSE(PassPlain(other));
  other.resource_limit = kNan;
  EXPECT_FALSE(PassPlain(other));
  other = plain;
  other.more_limits = {5.0};
  EXPECT_FALSE(PassPlain(other));
  other = plain;
  other.stages[0].via.resize(other.stages[0].seams.size());
  EXPECT_FALSE(PassPlain(other));
  other = plain;
  other.stages[0].nodes[0].tokens = {{1, 1.0}};
  EXPECT_FALSE(PassPlain(other));
  other = plain;
  other.stages[0].nodes[0].reward = kNan;
  EXPECT_FALSE(PassPlain(other));
  other.stages[0].nodes[0].reward = 1.7e308;
  other.stages[1].nodes[0].reward = 1.7e308;
  EXPECT_FALSE(PassPlain(other));
  EXPECT_TRUE(PassPlain(plain));
}

}  // namespace
}  // namespace kg_planner
