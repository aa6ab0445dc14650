#include "kg_ros/display/work_marker.h"

#include <limits>

#include "gtest/gtest.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "std_msgs/ColorRGBA.h"

namespace kg_ros {
namespace {

using kg_compiler::CellAccess;

constexpr float kLand = std::numeric_limits<float>::quiet_NaN();

// Six cells in two rows.
kg_base::Grid SixCells() {
  return kg_base::Grid({-90.0, -89.9, -89.7}, {25.0, 25.1});
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

// Colour of the marker at a point of the map.
std_msgs::ColorRGBA ColourAt(const visualization_msgs::Marker& marker,
                             const kg_base::MapPoint& at) {
  std_msgs::ColorRGBA colour;  // No marker: transparent.
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
  const kg_base::Grid grid = SixCells();
  const kg_base::MapProjection map(grid.Middle());
  kg_compiler::WorkMap work = Work();
  work.access[3] = CellAccess::kReached;
  work.time_s[3] = 1000.0F;
  const auto marker = ToWorkMarker(grid, work, {{-89.9, 25.0}}, map);
  const auto at = [&](int row, int col) {
    // Off the centre, which may have a place marker.
    kg_base::LonLat centre = grid.Centre({row, col});
    centre.lat_deg += 0.02;
    return ColourAt(marker, map.Forward(centre));
  };
  EXPECT_EQ(marker.points.size(), marker.colors.size());
  EXPECT_GT(at(1, 2).g, 0.8F);  // No time needed.
  EXPECT_EQ(at(1, 2).r, 0.0F);
  EXPECT_GT(at(1, 0).r, 0.9F);  // Takes all available time.
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
  const kg_base::Grid grid({-90.0, -89.9, -89.8, -89.7}, {25.0, 25.1});
  kg_compiler::WorkMap work;
  work.budget_s = 1.0;
  work.access.assign(8, CellAccess::kTooFar);
  work.time_s.assign(8, kLand);
  work.access[5] = CellAccess::kReached;
  work.time_s[5] = 0.0F;
  const auto marker =
      ToWorkMarker(grid, work, {}, kg_base::MapProjection(grid.Middle()));
  EXPECT_EQ(marker.points.size(), 6u * (1 + 3));
}

}  // namespace
}  // namespace kg_ros
