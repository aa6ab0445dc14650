#include "kg_ros/display/clicked_point.h"

#include <cmath>
#include <limits>

#include "GeographicLib/Geocentric.hpp"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "tf2/LinearMath/Quaternion.h"

namespace kg_ros {
namespace {

using kg_base::LonLat;
using kg_base::MapProjection;
using testing::HasSubstr;

constexpr LonLat kCentre = {-90.0, 26.0};
constexpr double kTolerance_deg = 1e-9;  // 0.1 mm.

geometry_msgs::PointStamped Point(const std::string& frame, const double x_m,
                                  const double y_m, const double z_m = 0.0) {
  geometry_msgs::PointStamped point;
  point.header.frame_id = frame;
  point.header.stamp = ros::Time(1000.0);  // Later than every transform.
  point.point.x = x_m;
  point.point.y = y_m;
  point.point.z = z_m;
  return point;
}

class ClickedPoint : public testing::Test {
 protected:
  // `child` at (x, y, z) of `parent`, turned about z by `yaw_rad`.
  void Attach(const std::string& parent, const std::string& child,
              const double x_m, const double y_m, const double yaw_rad,
              const double z_m = 0.0, const double stamp_s = 1.0) {
    tf2::Quaternion rotation;
    rotation.setRPY(0.0, 0.0, yaw_rad);
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(stamp_s);
    transform.child_frame_id = child;
    transform.transform.translation.x = x_m;
    transform.transform.translation.y = y_m;
    transform.transform.translation.z = z_m;
    transform.transform.rotation.z = rotation.z();
    transform.transform.rotation.w = rotation.w();
    ASSERT_TRUE(frames_.setTransform(transform, "test"));
  }

  void ExpectPosition(const geometry_msgs::PointStamped& clicked,
                      const LonLat& expected) const {
    const LonLat found = ToPosition(clicked, frames_, map_);
    EXPECT_NEAR(expected.lon_deg, found.lon_deg, kTolerance_deg);
    EXPECT_NEAR(expected.lat_deg, found.lat_deg, kTolerance_deg);
  }

  tf2::BufferCore frames_;
  MapProjection map_{kCentre};
};

TEST_F(ClickedPoint, OfTheMapNeedsNoTransform) {
  ExpectPosition(Point("map", 40e3, -30e3), map_.Inverse({40e3, -30e3}));
}

TEST_F(ClickedPoint, BelowTheMapIsTurnedAndMoved) {
  // The ship's x axis points north of the map, its y axis west.
  Attach("map", "ship", 1000.0, 2000.0, std::acos(0.0));
  Attach("ship", "ship/radar", 10.0, 0.0, 0.0, 15.0);
  ExpectPosition(Point("ship", 300.0, 50.0), map_.Inverse({950.0, 2300.0}));
  ExpectPosition(Point("ship/radar", 300.0, 50.0, -15.0),
                 map_.Inverse({950.0, 2310.0}));
}

TEST_F(ClickedPoint, FollowsTheNewestTransform) {
  Attach("map", "ship", 0.0, 0.0, 0.0, 0.0, 1.0);
  Attach("map", "ship", 500.0, 0.0, 0.0, 0.0, 2.0);
  ExpectPosition(Point("ship", 0.0, 0.0), map_.Inverse({500.0, 0.0}));
}

TEST_F(ClickedPoint, OfTheEarthIsGeodeticFarFromTheCentre) {
  const LonLat place = {-84.0, 30.0};
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  GeographicLib::Geocentric::WGS84().Forward(place.lat_deg, place.lon_deg,
                                             120.0, x_m, y_m, z_m);
  ExpectPosition(Point("earth", x_m, y_m, z_m), place);
  // A frame outside `map`: the plane would be wrong by kilometres.
  Attach("earth", "map", 1e6, 2e6, 0.3);
  Attach("earth", "buoy", x_m, y_m, 1.0, z_m);
  ExpectPosition(Point("buoy", 0.0, 0.0), place);
}

TEST_F(ClickedPoint, AcrossTheAntimeridianCountsFromTheCentre) {
  map_ = MapProjection({179.5, 10.0});
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  GeographicLib::Geocentric::WGS84().Forward(10.0, -179.5, 0.0, x_m, y_m, z_m);
  ExpectPosition(Point("earth", x_m, y_m, z_m), {180.5, 10.0});
}

TEST_F(ClickedPoint, OfAnUnconnectedFrameIsRefusedByName) {
  Attach("odom", "ship", 0.0, 0.0, 0.0);
  for (const char* frame : {"ship", "nowhere", "", "/map"}) {
    try {
      ToPosition(Point(frame, 1.0, 2.0), frames_, map_);
      FAIL() << frame;
    } catch (const kg_base::InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("'" + std::string(frame) + "'"));
      EXPECT_THAT(error.what(), HasSubstr("'map' or 'earth'"));
    }
  }
}

TEST_F(ClickedPoint, OfALoopOfFramesIsRefused) {
  Attach("a", "b", 0.0, 0.0, 0.0);
  Attach("b", "a", 0.0, 0.0, 0.0);
  EXPECT_THROW(ToPosition(Point("a", 0.0, 0.0), frames_, map_),
               kg_base::InputError);
}

TEST_F(ClickedPoint, IsRefusedIfNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(
      std::isnan(ToPosition(Point("map", nan, 0.0), frames_, map_).lon_deg));
  EXPECT_TRUE(
      std::isnan(ToPosition(Point("earth", nan, 0.0), frames_, map_).lat_deg));
}

}  // namespace
}  // namespace kg_ros
