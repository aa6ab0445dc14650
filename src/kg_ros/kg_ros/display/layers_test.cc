#include "kg_ros/display/layers.h"

#include <cmath>
#include <string>

#include "gtest/gtest.h"
#include "kg_ros/display/work_marker.h"

namespace kg_ros {
namespace {

using kg_compiler::CellAccess;
using kg_compiler::Layer;

constexpr float kLand = std::numeric_limits<float>::quiet_NaN();

// Six cells in two rows: worthless, forbidden, land / three of value.
kg_compiler::MissionTensor SixCells() {
  kg_compiler::MissionTensor tensor;
  tensor.grid = kg_core::Grid({-90.0, -89.9, -89.7}, {25.0, 25.1});
  tensor.content = kg_compiler::HoldLayers(
      {{Layer::kReward, {0.0F, 0.8F, 0.0F, 0.2F, 0.4F, 0.8F}},
       {Layer::kUncertainty, {0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F}},
       {Layer::kPolicy, {0.0F, -2.0F, 9.0F, 1.0F, 2.0F, 4.0F}},
       {Layer::kAttenuation, {1.0F, 0.4F, 1.0F, 1.0F, 0.0F, 1.0F}},
       {Layer::kFeasibility, {1.0F, 0.0F, kLand, 1.0F, 1.0F, 1.0F}},
       {Layer::kFused, {0.0F, 0.0F, 0.0F, 0.1F, 0.2F, 0.4F}}});
  return tensor;
}

// From the third cell of value: the first is too far.
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

// The colour of the marker at a place of the map.
std_msgs::ColorRGBA ColourAt(const visualization_msgs::Marker& marker,
                             const kg_core::MapPoint& at) {
  std_msgs::ColorRGBA colour;  // Nothing there: transparent.
  for (std::size_t i = 0; i + 5 < marker.points.size(); i += 6) {
    const auto& low = marker.points[i];
    const auto& high = marker.points[i + 5 - 1];
    if (at.x_m >= low.x && at.x_m <= high.x && at.y_m >= low.y &&
        at.y_m <= high.y) {
      colour = marker.colors[i];
    }
  }
  return colour;
}

TEST(WorkMarker, IsGreenRedAndDarkRedAndLeavesLandOut) {
  const kg_compiler::MissionTensor tensor = SixCells();
  const kg_core::MapProjection map(tensor.grid.Middle());
  kg_compiler::WorkMap work = Work();
  work.access[3] = CellAccess::kReached;
  work.time_s[3] = 1000.0F;
  const auto marker = ToWorkMarker(tensor.grid, work, {{-89.9, 25.0}}, map);
  const auto at = [&](int row, int col) {
    // Beside the middle, where a place may be marked.
    kg_core::LonLat centre = tensor.grid.Centre({row, col});
    centre.lat_deg += 0.02;
    return ColourAt(marker, map.Forward(centre));
  };
  EXPECT_EQ(marker.points.size(), marker.colors.size());
  EXPECT_GT(at(1, 2).g, 0.8F);  // At once.
  EXPECT_EQ(at(1, 2).r, 0.0F);
  EXPECT_GT(at(1, 0).r, 0.9F);  // With the last of the time.
  EXPECT_EQ(at(1, 0).g, 0.0F);
  EXPECT_GT(at(1, 1).g, 0.5F);  // Half way: yellow.
  EXPECT_GT(at(1, 1).r, 0.5F);
  for (const int col : {0, 1}) {
    EXPECT_EQ(at(0, col).r, 0.3F);
    EXPECT_EQ(at(0, col).g, 0.0F);
    EXPECT_GT(at(0, col).a, 0.0F);
  }
  EXPECT_EQ(at(0, 2).a, 0.0F);
  const auto white = ColourAt(marker, map.Forward({-89.9, 25.0}));
  EXPECT_EQ(white.r + white.g + white.b, 3.0F);
}

TEST(WorkMarker, RunsOfOneColourAreOneRectangle) {
  const kg_core::Grid grid({-90.0, -89.9, -89.8, -89.7}, {25.0, 25.1});
  kg_compiler::WorkMap work;
  work.budget_s = 1.0;
  work.access.assign(8, CellAccess::kTooFar);
  work.time_s.assign(8, kLand);
  work.access[5] = CellAccess::kReached;
  work.time_s[5] = 0.0F;
  const auto marker =
      ToWorkMarker(grid, work, {}, kg_core::MapProjection(grid.Middle()));
  EXPECT_EQ(marker.points.size(), 6u * (1 + 3));
}

}  // namespace
}  // namespace kg_ros
