#include "kg_ros/display/raster_map.h"

#include <cmath>
#include <cstddef>

#include "kg_engine/display/layers.h"
#include "kg_ros/base/names.h"

namespace kg_ros {
namespace {

using kg_base::Axis;
using kg_base::Grid;
using kg_base::MapPoint;
using kg_engine::kNoDataPercent;

constexpr int kOutside = -1;

nav_msgs::OccupancyGrid Frame(const Grid& grid,
                              const kg_base::MapProjection& map) {
  const MapPoint low = map.Forward({grid.west_deg(), grid.south_deg()});
  const MapPoint high = map.Forward({grid.east_deg(), grid.north_deg()});
  const double side_m = (high.y_m - low.y_m) / grid.rows();
  nav_msgs::OccupancyGrid frame;
  frame.header.frame_id = kMapFrame;
  frame.info.resolution = static_cast<float>(side_m);
  frame.info.height = grid.rows();
  frame.info.width =
      static_cast<unsigned>(std::ceil((high.x_m - low.x_m) / side_m));
  frame.info.origin.position.x = low.x_m;
  frame.info.origin.position.y = low.y_m;
  frame.info.origin.orientation.w = 1.0;
  return frame;
}

// Index of the axis cell that contains a coordinate.
int CellOf(const Axis& axis, double coordinate) {
  const auto at = axis.Locate(coordinate);
  if (!at) return kOutside;
  const int last = static_cast<int>(axis.centres().size()) - 1;
  return std::min(last, static_cast<int>(std::max(0.0, *at + 0.5)));
}

}  // namespace

// Columns depend on x only and rows on y only, because the projection is
// cylindrical.
nav_msgs::OccupancyGrid ToOccupancyGrid(
    const Grid& grid, const std::vector<std::int8_t>& percents,
    const kg_base::MapProjection& map) {
  nav_msgs::OccupancyGrid shown = Frame(grid, map);
  const geometry_msgs::Point& origin = shown.info.origin.position;
  const double side_m = shown.info.resolution;
  // Longitude cell of each map column, then fill row by row.
  std::vector<int> columns;
  for (unsigned i = 0; i < shown.info.width; ++i) {
    const MapPoint at{origin.x + (i + 0.5) * side_m, origin.y};
    columns.push_back(CellOf(grid.lon_axis(), map.Inverse(at).lon_deg));
  }
  shown.data.reserve(columns.size() * shown.info.height);
  for (unsigned i = 0; i < shown.info.height; ++i) {
    const MapPoint at{origin.x, origin.y + (i + 0.5) * side_m};
    const int row = CellOf(grid.lat_axis(), map.Inverse(at).lat_deg);
    for (const int col : columns) {
      const bool inside = row != kOutside && col != kOutside;
      shown.data.push_back(inside ? percents[grid.Index({row, col})]
                                  : kNoDataPercent);
    }
  }
  return shown;
}

}  // namespace kg_ros
