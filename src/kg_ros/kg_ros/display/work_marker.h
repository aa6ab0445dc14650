// WORK in colour: from green (little time) over yellow to red (all available
// time), dark red = infeasible (too far, or forbidden); land is omitted. A
// white square marks each departure place.
//
// Triangles in the plane of the map, one rectangle per run of cells of one
// colour: exact on nonuniform grids, and few if little is reached.

#ifndef KG_ROS_DISPLAY_WORK_MARKER_H_
#define KG_ROS_DISPLAY_WORK_MARKER_H_

#include <vector>

#include "kg_base/geo/map_projection.h"
#include "kg_base/raster/grid.h"
#include "kg_compiler/control_plane/work.h"
#include "visualization_msgs/Marker.h"

namespace kg_ros {

visualization_msgs::Marker ToWorkMarker(
    const kg_base::Grid& grid, const kg_compiler::WorkMap& work,
    const std::vector<kg_base::LonLat>& places,
    const kg_base::MapProjection& map);

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_WORK_MARKER_H_
