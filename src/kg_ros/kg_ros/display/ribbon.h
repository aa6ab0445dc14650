// Lines and points as flat shapes in the plane of the map.
//
// rviz draws LINE_STRIP, LINE_LIST and POINTS as billboards facing the camera
// position. Its top-down view is 500 m above the map: from there a line some
// hundred kilometres away is edge-on and invisible. Flat triangles and cubes
// are visible from any position.

#ifndef KG_ROS_DISPLAY_RIBBON_H_
#define KG_ROS_DISPLAY_RIBBON_H_

#include "visualization_msgs/Marker.h"
#include "visualization_msgs/MarkerArray.h"

namespace kg_ros {

// Converts LINE_STRIP and LINE_LIST (width scale.x) into a TRIANGLE_LIST,
// POINTS (scale.x, scale.y) into a CUBE_LIST; other markers are unchanged.
void Flatten(visualization_msgs::Marker* marker);

// Removes triangle markers without triangles, which rviz reports as errors.
void RemoveEmptyLists(visualization_msgs::MarkerArray* markers);

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_RIBBON_H_
