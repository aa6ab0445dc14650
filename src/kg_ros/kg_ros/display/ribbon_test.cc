#include "kg_ros/display/ribbon.h"

#include <cmath>

#include "gtest/gtest.h"

namespace kg_ros {
namespace {

using geometry_msgs::Point;
using visualization_msgs::Marker;

Point At(double x, double y, double z = 7.0) {
  Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

Marker Line(int type, std::vector<Point> points) {
  Marker marker;
  marker.type = type;
  marker.scale.x = 4.0;
  marker.points = std::move(points);
  return marker;
}

double Area(const Marker& marker) {
  double area = 0.0;
  for (std::size_t i = 0; i < marker.points.size(); i += 3) {
    const Point& a = marker.points[i];
    const Point& b = marker.points[i + 1];
    const Point& c = marker.points[i + 2];
    area += std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
  }
  return area;
}

TEST(RibbonTest, ALegBecomesARectangleOfTheLinesWidth) {
  Marker marker = Line(Marker::LINE_STRIP, {At(1.0, 2.0), At(31.0, 42.0)});
  Flatten(&marker);
  EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
  ASSERT_EQ(marker.points.size(), 6u);
  // A quarter of the width longer at both ends.
  EXPECT_NEAR(Area(marker), 4.0 * (50.0 + 2.0), 1e-9);
  for (const Point& point : marker.points) EXPECT_EQ(point.z, 7.0);
  EXPECT_EQ(marker.scale.x, 1.0);
}

TEST(RibbonTest, StraightRunsBecomeOneLegAndCornersStay) {
  Marker marker =
      Line(Marker::LINE_STRIP, {At(0, 0), At(10, 0), At(20, 0), At(20, 10)});
  Flatten(&marker);
  EXPECT_EQ(marker.points.size(), 12u);
  EXPECT_NEAR(Area(marker), 4.0 * (20.0 + 2.0) + 4.0 * (10.0 + 2.0), 1e-9);
}

TEST(RibbonTest, AListOfLinesKeepsItsGaps) {
  Marker marker =
      Line(Marker::LINE_LIST, {At(0, 0), At(10, 0), At(20, 0), At(30, 0)});
  Flatten(&marker);
  EXPECT_EQ(marker.points.size(), 12u);
}

TEST(RibbonTest, RestingAddsNothing) {
  Marker marker = Line(Marker::LINE_STRIP, {At(5, 5), At(5, 5)});
  Flatten(&marker);
  EXPECT_TRUE(marker.points.empty());
}

TEST(RibbonTest, RemovesWhatHasNoTriangles) {
  visualization_msgs::MarkerArray markers;
  markers.markers = {Line(Marker::LINE_STRIP, {At(5, 5), At(5, 5)}),
                     Line(Marker::LINE_STRIP, {At(5, 5), At(6, 5)}), Marker()};
  for (Marker& marker : markers.markers) Flatten(&marker);
  RemoveEmptyLists(&markers);
  EXPECT_EQ(markers.markers.size(), 2u);
}

TEST(RibbonTest, PointsBecomeFlatCubesAndOtherMarkersStay) {
  Marker marker = Line(Marker::POINTS, {At(5, 5)});
  Flatten(&marker);
  EXPECT_EQ(marker.type, Marker::CUBE_LIST);
  EXPECT_GT(marker.scale.z, 0.0);
  Marker cylinder;
  cylinder.type = Marker::CYLINDER;
  Flatten(&cylinder);
  EXPECT_EQ(cylinder.type, Marker::CYLINDER);
}

}  // namespace
}  // namespace kg_ros
