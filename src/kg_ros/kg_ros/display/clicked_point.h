// WGS84 position of a point clicked in any tf frame.
//
// The tree of frames is
//
//   earth -> map -> <agent>/base_link
//
// and whatever other nodes attach to it. `map` is a plane (MapProjection), so
// the rigid transform earth -> map is exact at its origin only. Therefore
//
//   frame at or below `map`:  newest transform to `map`, inverse projection
//   any other frame:          newest transform to `earth` (geocentric, metres),
//                             geodetic longitude and latitude
//
// Height is ignored. The newest transform is used instead of the one at the
// point's stamp because it is what the operator saw when clicking.

#ifndef KG_ROS_DISPLAY_CLICKED_POINT_H_
#define KG_ROS_DISPLAY_CLICKED_POINT_H_

#include "geometry_msgs/PointStamped.h"
#include "kg_base/geo/lon_lat.h"
#include "kg_base/geo/map_projection.h"
#include "tf2/buffer_core.h"

namespace kg_ros {

// The longitude is within 180 degrees of the projection's centre; both
// coordinates are NaN if the point is not finite. Throws kg_base::InputError
// naming the frame, in one line, if there is no transform from it to `map` or
// `earth`.
kg_base::LonLat ToPosition(const geometry_msgs::PointStamped& clicked,
                           const tf2::BufferCore& frames,
                           const kg_base::MapProjection& map);

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_CLICKED_POINT_H_
