#include "kg_ros/display/work_marker.h"

#include <algorithm>
#include <cmath>

#include "kg_ros/base/names.h"

namespace kg_ros {
namespace {

using kg_base::LonLat;
using kg_compiler::CellAccess;
using visualization_msgs::Marker;

constexpr double kHeight_m = 50.0;  // Above heatmaps, below all other markers.
constexpr float kOpacity = 0.9F;
constexpr int kShades = 32;           // Shades from green to red.
constexpr int kInfeasible = kShades;  // Index after the shades.
constexpr int kNothing = -1;
// Map width / side of a place's square.
constexpr double kPlacesAcross = 150.0;

int ShadeOf(const kg_compiler::WorkMap& work, std::size_t cell) {
  if (work.access[cell] == CellAccess::kNoData) return kNothing;
  const std::optional<double> share = work.Share(cell);
  if (!share) return kInfeasible;
  return std::min(kShades - 1, static_cast<int>(*share * kShades));
}

std_msgs::ColorRGBA ColourOf(int shade) {
  std_msgs::ColorRGBA colour;
  colour.a = kOpacity;
  if (shade == kInfeasible) {
    colour.r = 0.3F;
    return colour;
  }
  const float share =
      static_cast<float>(shade) / static_cast<float>(kShades - 1);
  colour.r = std::min(1.0F, 2.0F * share);
  colour.g = std::min(1.0F, 2.0F - 2.0F * share) * 0.85F;
  return colour;
}

struct Corners {
  double west_m, south_m, east_m, north_m;
};

class Painter {
 public:
  Painter(const kg_base::Grid& grid, const kg_base::MapProjection& map,
          Marker* marker)
      : grid_(grid), marker_(marker) {
    for (int col = 0; col <= grid.cols(); ++col) {
      x_m_.push_back(map.Forward({grid.lon_axis().Edge(col), 0.0}).x_m);
    }
    for (int row = 0; row <= grid.rows(); ++row) {
      y_m_.push_back(map.Forward({0.0, grid.lat_axis().Edge(row)}).y_m);
    }
  }

  void Row(const kg_compiler::WorkMap& work, int row) {
    int begin = 0;
    for (int col = 1; col <= grid_.cols(); ++col) {
      const int shade = ShadeOf(work, grid_.Index({row, begin}));
      if (col < grid_.cols() &&
          ShadeOf(work, grid_.Index({row, col})) == shade) {
        continue;
      }
      if (shade != kNothing) {
        Rectangle({x_m_[begin], y_m_[row], x_m_[col], y_m_[row + 1]}, kHeight_m,
                  ColourOf(shade));
      }
      begin = col;
    }
  }
  void Square(const kg_base::MapPoint& middle) {
    const double half_m = 0.5 * (x_m_.back() - x_m_.front()) / kPlacesAcross;
    std_msgs::ColorRGBA white;
    white.r = white.g = white.b = white.a = 1.0F;
    Rectangle({middle.x_m - half_m, middle.y_m - half_m, middle.x_m + half_m,
               middle.y_m + half_m},
              2.0 * kHeight_m, white);
  }

 private:
  void Rectangle(const Corners& at, double z_m,
                 const std_msgs::ColorRGBA& colour) {
    const double x_m[] = {at.west_m, at.east_m, at.east_m,
                          at.west_m, at.east_m, at.west_m};
    const double y_m[] = {at.south_m, at.south_m, at.north_m,
                          at.south_m, at.north_m, at.north_m};
    for (int i = 0; i < 6; ++i) {
      marker_->points.emplace_back();
      marker_->points.back().x = x_m[i];
      marker_->points.back().y = y_m[i];
      marker_->points.back().z = z_m;
      marker_->colors.push_back(colour);
    }
  }

  const kg_base::Grid& grid_;
  Marker* marker_;
  std::vector<double> x_m_, y_m_;  // Edges of columns and rows.
};

}  // namespace

Marker ToWorkMarker(const kg_base::Grid& grid, const kg_compiler::WorkMap& work,
                    const std::vector<LonLat>& places,
                    const kg_base::MapProjection& map) {
  Marker marker;
  marker.header.frame_id = kMapFrame;
  marker.ns = "work";
  marker.type = Marker::TRIANGLE_LIST;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = 1.0F;
  Painter paint(grid, map, &marker);
  for (int row = 0; row < grid.rows(); ++row) paint.Row(work, row);
  for (const LonLat& place : places) paint.Square(map.Forward(place));
  return marker;
}

}  // namespace kg_ros
