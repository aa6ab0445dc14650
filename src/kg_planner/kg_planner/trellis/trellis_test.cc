#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "gtest/gtest.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two stages of two nodes, fully connected.
Trellis Sound() {
  Trellis trellis;
  trellis.stages.resize(2);
  for (Stage& stage : trellis.stages) stage.nodes.resize(2);
  trellis.stages[0].nodes[1] = {-3.0, {{4, 1.0}}};
  trellis.stages[0].seams = {{0, 1, 1.0, 2.0}, {0, 0, 0.0, 0.0}};
  trellis.stages[1].seams = {{0, 0}, {1, 1}, {0, 1}, {1, 0}};
  return trellis;
}

TEST(TrellisTest, SoundOnesPass) {
  EXPECT_NO_THROW(CheckTrellis(Sound()));
  EXPECT_NO_THROW(CheckTrellis({}));
  Trellis empty_stage;
  empty_stage.stages.resize(2);
  EXPECT_NO_THROW(CheckTrellis(empty_stage));
}

TEST(TrellisTest, ParallelSeamsOverOtherStopsPass) {
  Trellis trellis = Sound();
  trellis.stages[1].nodes.resize(4);
  trellis.stages[1].seams[2] = {1, 1};
  trellis.stages[1].seams[0] = {1, 1};
  trellis.stages[1].via = {{2, 3}, {}, {3, 2}, {}};
  EXPECT_NO_THROW(CheckTrellis(trellis));
}

struct TrellisMistake {
  const char* name;
  std::function<void(Trellis*)> make;
  const char* stage;  // Text the message must contain.
  const char* what;
};

TrellisMistake OfSeam(const char* name, Seam seam) {
  return {name, [seam](Trellis* t) { t->stages[1].seams[2] = seam; }, "stage 1",
          "seam 2"};
}

std::vector<TrellisMistake> Mistakes() {
  return {
      OfSeam("from below", {-1, 1}),
      OfSeam("from beyond", {2, 1}),
      OfSeam("to below", {0, -1}),
      OfSeam("to beyond", {0, 2}),
      OfSeam("cost negative", {0, 1, -0.1}),
      OfSeam("cost NaN", {0, 1, kNan}),
      OfSeam("cost infinite", {0, 1, kInfinity}),
      OfSeam("resource negative", {0, 1, 0.0, -0.1}),
      OfSeam("resource NaN", {0, 1, 0.0, kNan}),
      OfSeam("resource infinite", {0, 1, 0.0, kInfinity}),
      OfSeam("twice", {1, 1}),
      {"start beyond", [](Trellis* t) { t->stages[0].seams[0].from = 1; },
       "stage 0", "seam 0"},
      {"reward NaN", [](Trellis* t) { t->stages[0].nodes[1].reward = kNan; },
       "stage 0", "node 1"},
      {"reward infinite",
       [](Trellis* t) { t->stages[1].nodes[0].reward = -kInfinity; }, "stage 1",
       "node 0"},
      {"token negative",
       [](Trellis* t) { t->stages[0].nodes[1].tokens[0].reward = -1.0; },
       "stage 0", "token 4"},
      {"token NaN",
       [](Trellis* t) { t->stages[0].nodes[1].tokens[0].reward = kNan; },
       "stage 0", "token 4"},
      {"via of too few",
       [](Trellis* t) {
         t->stages[1].via = {{}, {}};
       },
       "stage 1", "via: of 2 seams, expected 4"},
      {"via beyond",
       [](Trellis* t) {
         t->stages[1].via = {{}, {}, {2}, {}};
       },
       "stage 1, seam 2", "via node 2 is not one"},
      {"via below",
       [](Trellis* t) {
         t->stages[1].via = {{}, {}, {-1}, {}};
       },
       "stage 1, seam 2", "via node -1 is not one"},
      {"via its own end",
       [](Trellis* t) {
         t->stages[1].via = {{}, {}, {1}, {}};
       },
       "stage 1, seam 2", "via node 1 is visited twice"},
      {"via twice",
       [](Trellis* t) {
         t->stages[1].via = {{}, {}, {0, 0}, {}};
       },
       "stage 1, seam 2", "via node 0 is visited twice"},
      {"the same via twice",
       [](Trellis* t) {
         t->stages[1].seams[0] = t->stages[1].seams[2] = {0, 1};
         t->stages[1].via = {{0}, {}, {0}, {}};
       },
       "stage 1, seam 2", "occurs twice with the same via"},
      {"resource missing", [](Trellis* t) { t->more_limits = {1.0}; },
       "stage 0", "0 resources, expected 1"},
      {"resource unlimited",
       [](Trellis* t) {
         t->stages[1].more_resources = {{0.0, 0.0, 0.0, 0.0}};
       },
       "stage 1", "1 resources, expected 0"},
      {"resource of too few",
       [](Trellis* t) {
         t->more_limits = {1.0};
         t->stages[0].more_resources = {{0.0, 0.0}};
         t->stages[1].more_resources = {{0.0, 0.0}};
       },
       "stage 1, resource 1", "of 2 seams, expected 4"},
      {"second resource NaN",
       [](Trellis* t) {
         t->more_limits = {1.0};
         t->stages[0].more_resources = {{0.0, kNan}};
       },
       "stage 0, seam 1", "resource 1 is nan"},
      {"second limit NaN",
       [](Trellis* t) {
         t->more_limits = {kNan};
         t->stages[0].more_resources = {{0.0, 0.0}};
         t->stages[1].more_resources = {{0.0, 0.0, 0.0, 0.0}};
       },
       "", "limit of resource 1"},
      {"limit NaN", [](Trellis* t) { t->resource_limit = kNan; }, "", "limit"},
  };
}

TEST(TrellisTest, EveryMistakeIsNamedWithItsPlace) {
  for (const TrellisMistake& mistake : Mistakes()) {
    Trellis trellis = Sound();
    mistake.make(&trellis);
    try {
      CheckTrellis(trellis);
      ADD_FAILURE() << mistake.name << " passed";
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(mistake.stage), std::string::npos) << text;
      EXPECT_NE(text.find(mistake.what), std::string::npos) << text;
    }
  }
}

TEST(TrellisTest, MinusZeroIsNotNegative) {
  Trellis trellis = Sound();
  trellis.stages[1].seams[2] = {0, 1, -0.0, -0.0};
  EXPECT_NO_THROW(CheckTrellis(trellis));
}

TEST(TrellisTest, RefusesSumsThatOverflow) {
  Trellis trellis = Sound();
  for (Stage& stage : trellis.stages) stage.nodes[0].reward = 1.7e308;
  EXPECT_THROW(CheckTrellis(trellis), std::invalid_argument);
}

TEST(ScoreGridTest, SumsOfRoundedNumbersAreExact) {
  const ScoreGrid grid(1.0);
  const double a = grid.Round(0.1);
  const double b = grid.Round(0.2);
  const double c = grid.Round(0.3);
  EXPECT_EQ((a + b) + c, a + (b + c));
  EXPECT_EQ((c + a) + b, a + (b + c));
}

TEST(ScoreGridTest, RoundsToTheNearestMultipleOfItsStep) {
  for (const double largest : {1e-12, 0.7, 1.0, 3.0, 12345.6, 1e15}) {
    const ScoreGrid grid(largest);
    EXPECT_LE(grid.step(), largest * 0x1p-48);
    for (const double share : {-1.0, -0.3, 0.0, 1e-9, 0.1, 1.0 / 3.0, 1.0}) {
      const double rounded = grid.Round(share * largest);
      EXPECT_LE(std::abs(rounded - share * largest), grid.step() / 2.0);
      EXPECT_EQ(rounded, std::round(rounded / grid.step()) * grid.step());
      EXPECT_EQ(grid.Round(rounded), rounded);
    }
  }
}

}  // namespace
}  // namespace kg_planner
