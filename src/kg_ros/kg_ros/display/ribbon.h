// Lines and points as flat shapes in the plane of the map.
//
// rviz draws LINE_STRIP, LINE_LIST and POINTS as billboards that face the place
// of the camera. Its view from above stands 500 m over the map: seen from there
// a line some hundred kilometres away is edge-on, and nothing is drawn. Flat
// triangles and cubes are seen from anywhere.

#ifndef KG_ROS_DISPLAY_RIBBON_H_
#define KG_ROS_DISPLAY_RIBBON_H_

#include "visualization_msgs/Marker.h"
#include "visualization_msgs/MarkerArray.h"

namespace kg_ros {

// Turns LINE_STRIP and LINE_LIST (width scale.x) into a TRIANGLE_LIST, POINTS
// (scale.x, scale.y) into a CUBE_LIST; other markers stay what they are.
void Flatten(visualization_msgs::Marker* marker);

// Removes markers of triangles that have none: rviz calls them an error.
void RemoveEmptyLists(visualization_msgs::MarkerArray* markers);

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_RIBBON_H_
