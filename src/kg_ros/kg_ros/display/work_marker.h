// WORK in colour: green = easy, through yellow to red = takes all the time
// there is, dark red = infeasible (too far, or forbidden); land is left out. A
// white square stands at each place one departs from.
//
// Triangles in the plane of the map, a rectangle for each run of cells of one
// colour: exact on uneven grids, and few where nothing is reached.

#ifndef KG_ROS_DISPLAY_WORK_MARKER_H_
#define KG_ROS_DISPLAY_WORK_MARKER_H_

#include <vector>

#include "kg_compiler/control_plane/work.h"
#include "kg_core/geo/map_projection.h"
#include "kg_core/raster/grid.h"
#include "visualization_msgs/Marker.h"

namespace kg_ros {

visualization_msgs::Marker ToWorkMarker(
    const kg_core::Grid& grid, const kg_compiler::WorkMap& work,
    const std::vector<kg_core::LonLat>& places,
    const kg_core::MapProjection& map);

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_WORK_MARKER_H_
