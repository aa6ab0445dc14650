// Messages for rviz: correct cells and colours, only finite numbers.

#include "kg_ros/display/display.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "gtest/gtest.h"
#include "kg_engine/display/layers.h"
#include "kg_ros/display/raster_map.h"

namespace kg_ros {
namespace {

using kg_compiler::Layer;

kg_base::Grid RegularGrid(int rows, int cols) {
  std::vector<double> lon_deg;
  std::vector<double> lat_deg;
  for (int i = 0; i < cols; ++i) lon_deg.push_back(-90.0 + 0.1 * i);
  for (int i = 0; i < rows; ++i) lat_deg.push_back(25.0 + 0.1 * i);
  return kg_base::Grid(lon_deg, lat_deg);
}

kg_compiler::MissionTensor TensorWithOneHill(int rows, int cols) {
  kg_compiler::MissionTensor tensor;
  tensor.grid = RegularGrid(rows, cols);
  kg_base::Raster fused(tensor.grid.size(), 0.1F);
  kg_base::Raster feasible(tensor.grid.size(), 1.0F);
  fused[tensor.grid.Index({2, 3})] = 0.4F;
  fused[0] = 0.0F;
  feasible[0] = std::nanf("");  // Land in the south-west.
  tensor.content = kg_compiler::HoldLayers(
      {{Layer::kFused, fused}, {Layer::kFeasibility, feasible}});
  return tensor;
}

nav_msgs::OccupancyGrid ToHeatmap(const kg_compiler::MissionTensor& tensor,
                                  const kg_base::MapProjection& map) {
  return ToOccupancyGrid(tensor.grid, kg_engine::FusedPercents(tensor), map);
}

kg_engine::AgentGraph GraphOf(
    const std::vector<kg_compiler::TraverseEdge>& edges) {
  kg_compiler::NavGraph made;
  made.edges = edges;
  kg_engine::AgentGraph graph;
  graph.agent = "alpha";
  graph.graph = std::make_shared<const kg_compiler::NavGraph>(made);
  return graph;
}

int ValueAt(const nav_msgs::OccupancyGrid& heatmap,
            const kg_base::MapPoint& point) {
  const double side_m = heatmap.info.resolution;
  const auto col = static_cast<unsigned>(
      (point.x_m - heatmap.info.origin.position.x) / side_m);
  const auto row = static_cast<unsigned>(
      (point.y_m - heatmap.info.origin.position.y) / side_m);
  return heatmap.data.at(row * heatmap.info.width + col);
}

TEST(DisplayTest, TheHeatmapShowsEachCellWhereItIs) {
  const kg_compiler::MissionTensor tensor = TensorWithOneHill(8, 10);
  const kg_base::MapProjection map(tensor.grid.Middle());
  const nav_msgs::OccupancyGrid heatmap = ToHeatmap(tensor, map);
  EXPECT_EQ(ValueAt(heatmap, map.Forward(tensor.grid.Centre({2, 3}))), 100);
  EXPECT_EQ(ValueAt(heatmap, map.Forward(tensor.grid.Centre({5, 5}))), 25);
  EXPECT_EQ(ValueAt(heatmap, map.Forward(tensor.grid.Centre({0, 0}))), -1);
}

TEST(DisplayTest, AFewBrightCellsDoNotLeaveTheRestDark) {
  kg_compiler::MissionTensor tensor = TensorWithOneHill(40, 50);
  const kg_base::MapProjection map(tensor.grid.Middle());
  const nav_msgs::OccupancyGrid heatmap = ToHeatmap(tensor, map);
  EXPECT_EQ(ValueAt(heatmap, map.Forward(tensor.grid.Centre({2, 3}))), 100);
  EXPECT_EQ(ValueAt(heatmap, map.Forward(tensor.grid.Centre({20, 20}))), 100);
}

TEST(DisplayTest, AnAllZeroTensorIsShownAsZero) {
  kg_compiler::MissionTensor tensor = TensorWithOneHill(4, 5);
  tensor.content = kg_compiler::HoldLayers(
      {{Layer::kFused, kg_base::Raster(tensor.grid.size(), 0.0F)},
       {Layer::kFeasibility, tensor.Get(Layer::kFeasibility)}});
  const kg_base::MapProjection map(tensor.grid.Middle());
  EXPECT_EQ(
      ValueAt(ToHeatmap(tensor, map), map.Forward(tensor.grid.Centre({2, 2}))),
      0);
}

TEST(DisplayTest, EmptyLinesAreLeftOut) {
  MarkerPainter paint{kg_base::MapProjection({-90.0, 25.0})};
  paint.PaintNavGraph(GraphOf({}));
  const visualization_msgs::MarkerArray markers = paint.Take();
  ASSERT_EQ(markers.markers.size(), 1u);
  EXPECT_EQ(markers.markers[0].action, visualization_msgs::Marker::DELETEALL);
}

// Texts of facts off the grid or without a place stay in view, none over
// another.
TEST(DisplayTest, WarningsAreTextsOnTheGrid) {
  const kg_base::Grid grid = RegularGrid(8, 10);
  const kg_base::MapProjection map(grid.Middle());
  MarkerPainter paint{map};
  const kg_base::LonLat off{grid.east_deg() + 30.0, grid.Middle().lat_deg};
  paint.PaintWarnings({{"ex:a has no effect", "", off},
                       {"ex:b has no effect", "", off},
                       {"ex:land has no effect", "", std::nullopt}},
                      grid);
  const visualization_msgs::MarkerArray markers = paint.Take();
  ASSERT_EQ(markers.markers.size(), 4u);
  const kg_base::MapPoint edge =
      map.Forward({grid.east_deg(), grid.Middle().lat_deg});
  EXPECT_EQ(markers.markers[1].ns, "warnings");
  EXPECT_EQ(markers.markers[1].text, "ex:a has no effect");
  EXPECT_NEAR(markers.markers[1].pose.position.x, edge.x_m, 1.0);
  EXPECT_LT(markers.markers[2].pose.position.y,
            markers.markers[1].pose.position.y);
  EXPECT_NEAR(markers.markers[3].pose.position.x, 0.0, 1.0);
}

TEST(DisplayTest, ArrowsFollowTheFieldAndAreFinite) {
  kg_compiler::WorkField field;
  field.field.grid = RegularGrid(8, 10);
  kg_base::Raster east(80, 0.5F);
  east[11] = std::nanf("");
  field.field.slices = {{0.0, east, kg_base::Raster(80, 0.0F)}};
  MarkerPainter paint{kg_base::MapProjection({-89.5, 25.35})};
  paint.PaintField(field, 0.0);
  const visualization_msgs::MarkerArray markers = paint.Take();
  ASSERT_EQ(markers.markers.size(), 2u);
  const auto& points = markers.markers[1].points;
  ASSERT_GE(points.size(), 2u);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    EXPECT_GT(points[i + 1].x, points[i].x);
    EXPECT_EQ(points[i + 1].y, points[i].y);
    EXPECT_TRUE(std::isfinite(points[i].x) && std::isfinite(points[i + 1].x));
  }
}

// East, then north, as a current may require: not the straight line.
TEST(DisplayTest, TracksAreDrawnWithTheirTurningPoints) {
  const kg_base::MapProjection map({-90.0, 25.0});
  const kg_base::LonLat way[] = {{-90.2, 25.0}, {-89.8, 25.0}, {-89.8, 25.4}};
  std::vector<kg_compiler::TimedPoint> track(3);
  for (int i = 0; i < 3; ++i) track[i].position = way[i];
  kg_compiler::TraverseEdge edge;
  edge.flight.track = track;
  kg_engine::AgentGraph graph = GraphOf({edge});
  graph.staging = {true};
  kg_selector::PathAssignment assignment;
  assignment.pathlet.track = track;
  kg_selector::AgentCandidates candidates;
  candidates.found.pathlets = {assignment.pathlet};
  MarkerPainter paint{map};
  paint.PaintNavGraph(graph);
  paint.PaintStaging(graph);
  paint.PaintCandidates(candidates);
  paint.PaintAssignment(assignment);
  const kg_base::MapPoint turn = map.Forward(way[1]);
  const auto is_there = [&](const geometry_msgs::Point& point) {
    return std::hypot(point.x - turn.x_m, point.y - turn.y_m) < 1.0;
  };
  const visualization_msgs::MarkerArray markers = paint.Take();
  ASSERT_EQ(markers.markers.size(), 5u);  // The first erases.
  for (std::size_t i = 1; i < 5; ++i) {
    const auto& points = markers.markers[i].points;
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), is_there))
        << markers.markers[i].ns;
  }
  EXPECT_TRUE(
      is_there(ToPath(assignment.pathlet, map).poses.at(1).pose.position));
}

TEST(DisplayTest, StagingEdgesArePurple) {
  MarkerPainter paint{kg_base::MapProjection({-90.0, 25.0})};
  kg_compiler::TraverseEdge edge;
  edge.flight.track.resize(2);
  kg_engine::AgentGraph graph = GraphOf({edge, edge});
  graph.staging = {false, true};
  paint.PaintStaging(graph);
  const visualization_msgs::MarkerArray markers = paint.Take();
  ASSERT_EQ(markers.markers.size(), 2u);
  EXPECT_EQ(markers.markers[1].ns, "staging/alpha");
  EXPECT_GT(markers.markers[1].color.b, markers.markers[1].color.g);
  EXPECT_GT(markers.markers[1].color.r, markers.markers[1].color.g);
}

}  // namespace
}  // namespace kg_ros
