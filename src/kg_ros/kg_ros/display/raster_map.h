// Rasters on a longitude/latitude grid as occupancy grids for rviz: square
// cells of the map, each with the value of the grid's nearest cell.

#ifndef KG_ROS_DISPLAY_RASTER_MAP_H_
#define KG_ROS_DISPLAY_RASTER_MAP_H_

#include <cstdint>
#include <vector>

#include "kg_base/geo/map_projection.h"
#include "kg_base/raster/grid.h"
#include "nav_msgs/OccupancyGrid.h"

namespace kg_ros {

// `percents`: one value per cell of the grid. Cells outside of it have no data.
nav_msgs::OccupancyGrid ToOccupancyGrid(
    const kg_base::Grid& grid, const std::vector<std::int8_t>& percents,
    const kg_base::MapProjection& map);

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_RASTER_MAP_H_
