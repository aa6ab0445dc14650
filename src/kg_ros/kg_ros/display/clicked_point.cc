#include "kg_ros/display/clicked_point.h"

#include <cmath>
#include <string>

#include "GeographicLib/Geocentric.hpp"
#include "geometry_msgs/TransformStamped.h"
#include "kg_base/common/input_error.h"
#include "kg_ros/base/names.h"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/LinearMath/Vector3.h"
#include "tf2/exceptions.h"

namespace kg_ros {
namespace {

const ros::Time kNewest(0);

// Whether `map` is the frame itself or an ancestor.
bool IsBelowMap(const tf2::BufferCore& frames, std::string frame) {
  // Limits the walk if other nodes publish a loop of frames, which tf2 accepts.
  constexpr int kMaxDepth = 1000;
  for (int depth = 0; depth < kMaxDepth; ++depth) {
    if (frame == kMapFrame) return true;
    std::string parent;
    if (!frames._getParent(frame, kNewest, parent)) return false;
    frame = parent;
  }
  return false;
}

// Coordinates of the point in the frame `target` [m].
tf2::Vector3 Transform(const geometry_msgs::PointStamped& clicked,
                       const std::string& target,
                       const tf2::BufferCore& frames) {
  const tf2::Vector3 point(clicked.point.x, clicked.point.y, clicked.point.z);
  // tf2 does not know a frame before its first transform, not even to itself.
  if (clicked.header.frame_id == target) return point;
  const geometry_msgs::Transform found =
      frames.lookupTransform(target, clicked.header.frame_id, kNewest)
          .transform;
  const tf2::Quaternion rotation(found.rotation.x, found.rotation.y,
                                 found.rotation.z, found.rotation.w);
  const tf2::Vector3 origin(found.translation.x, found.translation.y,
                            found.translation.z);
  return tf2::Transform(rotation, origin) * point;
}

kg_base::LonLat FromEarth(const tf2::Vector3& point,
                          const kg_base::MapProjection& map) {
  double lat_deg = 0.0;
  double lon_deg = 0.0;
  double height_m = 0.0;
  GeographicLib::Geocentric::WGS84().Reverse(point.x(), point.y(), point.z(),
                                             lat_deg, lon_deg, height_m);
  // A grid may extend beyond 180 degrees: wrap around its centre.
  const double centre_deg = map.centre().lon_deg;
  return {centre_deg + std::remainder(lon_deg - centre_deg, 360.0), lat_deg};
}

}  // namespace

kg_base::LonLat ToPosition(const geometry_msgs::PointStamped& clicked,
                           const tf2::BufferCore& frames,
                           const kg_base::MapProjection& map) {
  const std::string& frame = clicked.header.frame_id;
  try {
    if (IsBelowMap(frames, frame)) {
      const tf2::Vector3 point = Transform(clicked, kMapFrame, frames);
      return map.Inverse({point.x(), point.y()});
    }
    return FromEarth(Transform(clicked, kEarthFrame, frames), map);
  } catch (const tf2::TransformException&) {
    throw kg_base::InputError("no transform from frame '" + frame + "' to '" +
                              kMapFrame + "' or '" + kEarthFrame +
                              "'; expected one of these or a frame that tf "
                              "connects to them");
  }
}

}  // namespace kg_ros
