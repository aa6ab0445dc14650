#include "kg_engine/display/layers.h"

#include <cmath>
#include <string>

#include "gtest/gtest.h"

namespace kg_engine {
namespace {

using kg_compiler::CellAccess;
using kg_compiler::Layer;

constexpr float kLand = std::numeric_limits<float>::quiet_NaN();

// Six cells in two rows: zero value, forbidden, land / three with value.
kg_compiler::MissionTensor SixCells() {
  kg_compiler::MissionTensor tensor;
  tensor.grid = kg_base::Grid({-90.0, -89.9, -89.7}, {25.0, 25.1});
  tensor.content = kg_compiler::HoldLayers(
      {{Layer::kReward, {0.0F, 0.8F, 0.0F, 0.2F, 0.4F, 0.8F}},
       {Layer::kUncertainty, {0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F}},
       {Layer::kPolicy, {0.0F, -2.0F, 9.0F, 1.0F, 2.0F, 4.0F}},
       {Layer::kAttenuation, {1.0F, 0.4F, 1.0F, 1.0F, 0.0F, 1.0F}},
       {Layer::kFeasibility, {1.0F, 0.0F, kLand, 1.0F, 1.0F, 1.0F}},
       {Layer::kFused, {0.0F, 0.0F, 0.0F, 0.1F, 0.2F, 0.4F}}});
  return tensor;
}

// Work from the third cell with value: the first one is out of reach.
kg_compiler::WorkMap Work() {
  kg_compiler::WorkMap work;
  work.budget_s = 1000.0;
  work.access = {CellAccess::kTooFar,  CellAccess::kForbidden,
                 CellAccess::kNoData,  CellAccess::kTooFar,
                 CellAccess::kReached, CellAccess::kReached};
  work.time_s = {kLand, kLand, kLand, kLand, 500.0F, 0.0F};
  return work;
}

Percents Of(const std::string& name) {
  const kg_compiler::WorkMap work = Work();
  for (const ShownLayer& layer : ShownLayers()) {
    if (name == layer.name) {
      return layer.paint(SixCells(), layer.of_pose ? &work : nullptr);
    }
  }
  ADD_FAILURE() << "no layer " << name;
  return {};
}

TEST(ShownLayers, HaveTheirStatedScales) {
  EXPECT_EQ(Of("REWARD"), (Percents{0, 100, -1, 25, 50, 100}));
  EXPECT_EQ(Of("UNCERTAINTY"), (Percents{30, 30, -1, 30, 30, 30}));
  EXPECT_EQ(Of("ATTENUATION"), (Percents{100, 40, -1, 100, 0, 100}));
  EXPECT_EQ(Of("FEASIBILITY"), (Percents{100, 0, -1, 100, 100, 100}));
  EXPECT_EQ(Of("FUSED"), (Percents{0, 0, -1, 25, 50, 100}));
}

TEST(ShownLayers, PolicyHasItsNothingInTheMiddle) {
  const Percents policy = Of("POLICY");  // The largest weight is on land.
  EXPECT_EQ(policy, (Percents{50, 25, -1, 63, 75, 100}));
}

TEST(ShownLayers, OfAPoseSayWhatIsReachedAndAtWhatCost) {
  EXPECT_EQ(Of("REACH"), (Percents{0, 0, -1, 0, 100, 100}));
  EXPECT_EQ(Of("WORK"), (Percents{99, 100, -1, 99, 49, 0}));
  // Half of 0.2 against all of 0.4.
  EXPECT_EQ(Of("FUSED_VIEW"), (Percents{0, 0, -1, 0, 25, 100}));
}

}  // namespace
}  // namespace kg_engine
