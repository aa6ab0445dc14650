#include "kg_ros/display/display.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry_msgs/Point.h"
#include "kg_base/common/units.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/message_units.h"
#include "std_msgs/ColorRGBA.h"

namespace kg_ros {
namespace {

using kg_base::Cell;
using kg_base::Grid;
using kg_base::LonLat;
using kg_base::MapPoint;
using kg_base::MapProjection;
using visualization_msgs::Marker;

constexpr double kArrowSpacing_m = 60e3;
constexpr double kArrowSeconds = 60e3;  // Arrow length = flow in this time.
// Faster flow scales all arrows down.
constexpr double kLongestArrow_mps = 2.0;
// Map width / length of an agent's arrow.
constexpr double kAgentsAcross = 60.0;

std_msgs::ColorRGBA Colour(double r, double g, double b, double a) {
  std_msgs::ColorRGBA colour;
  std::tie(colour.r, colour.g, colour.b, colour.a) =
      std::make_tuple(r, g, b, a);
  return colour;
}

geometry_msgs::Point ToPoint(const MapProjection& map, LonLat position,
                             double z_m = 0.0) {
  const MapPoint point = map.Forward(position);
  geometry_msgs::Point message;
  message.x = point.x_m;
  message.y = point.y_m;
  message.z = z_m;
  return message;
}

// Whether this cell without data has a neighbour with data.
bool IsCoast(const Grid& grid, const kg_base::Mask& land, Cell cell) {
  if (land[grid.Index(cell)] == 0) return false;
  for (const auto& [dr, dc] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
    const Cell next{cell.row + dr, cell.col + dc};
    if (grid.Contains(next) && land[grid.Index(next)] == 0) return true;
  }
  return false;
}

double Strongest_mps(const kg_base::VectorField& field) {
  double strongest_mps = 0.0;
  for (const kg_base::FieldSlice& slice : field.slices) {
    for (std::size_t i = 0; i < slice.east_mps.size(); ++i) {
      const double speed_mps =
          std::hypot(slice.east_mps[i], slice.north_mps[i]);
      if (speed_mps > strongest_mps) strongest_mps = speed_mps;
    }
  }
  return strongest_mps;
}

}  // namespace

double WidthOf(const Grid& grid, const MapProjection& map) {
  return map.Forward({grid.east_deg(), 0.0}).x_m -
         map.Forward({grid.west_deg(), 0.0}).x_m;
}

nav_msgs::Path ToPath(const kg_selector::Pathlet& pathlet,
                      const MapProjection& map) {
  nav_msgs::Path path;
  path.header.frame_id = kMapFrame;
  for (const kg_compiler::TimedPoint& point : pathlet.track) {
    path.poses.emplace_back();
    path.poses.back().header.frame_id = kMapFrame;
    path.poses.back().header.stamp = ToRosTime(point.time_s);
    path.poses.back().pose.position = ToPoint(map, point.position, 500.0);
    path.poses.back().pose.orientation.w = 1.0;
  }
  return path;
}

MarkerPainter::MarkerPainter(MapProjection map, double width_m)
    : map_(map), size_(std::min(1.0, width_m / kMapWidth_m)) {}

Marker& MarkerPainter::Add(const std::string& name, const int type) {
  markers_.markers.emplace_back();
  Marker& marker = markers_.markers.back();
  marker.header.frame_id = kMapFrame;
  marker.ns = name;
  marker.id = static_cast<int>(markers_.markers.size());
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  return marker;
}

void MarkerPainter::PaintConstraints(const kg_mission::Mission& mission,
                                     const int window) {
  for (const kg_mission::Constraint& constraint : mission.constraints) {
    const auto& windows = constraint.windows;
    const bool applies =
        windows.empty() ||
        std::find(windows.begin(), windows.end(), window) != windows.end();
    if (!constraint.area || !applies) continue;
    const kg_mission::RgbColour& colour =
        kg_mission::EffectOf(constraint.kind).colour;
    for (const std::vector<LonLat>& ring : constraint.area->Rings()) {
      Marker& marker = Add("constraints", Marker::LINE_STRIP);
      marker.scale.x = 4000.0 * size_;
      marker.color = Colour(colour.red, colour.green, colour.blue, 1.0);
      for (const LonLat& corner : ring) {
        marker.points.push_back(ToPoint(map_, corner, 300.0));
      }
    }
  }
}

void MarkerPainter::PaintEvents(const kg_mission::Mission& mission,
                                const int window) {
  for (const kg_mission::Event& event : mission.events) {
    if (std::find(event.windows.begin(), event.windows.end(), window) ==
        event.windows.end()) {
      continue;
    }
    Marker& marker = Add("events", Marker::CYLINDER);
    marker.pose.position = ToPoint(map_, event.position, 200.0);
    marker.scale.x = marker.scale.y =
        std::max(8000.0 * size_, 2.0 * event.radius_m);
    marker.scale.z = 100.0;
    marker.color = Colour(0.1, 0.8, 0.9, 0.6);
  }
}

void MarkerPainter::PaintLand(const kg_base::VectorField& field) {
  const kg_base::Mask land = field.NoData();
  Marker& marker = Add("land", Marker::POINTS);
  marker.scale.x = marker.scale.y = 5000.0 * size_;
  marker.color = Colour(0.35, 0.30, 0.25, 1.0);
  for (int row = 0; row < field.grid.rows(); ++row) {
    for (int col = 0; col < field.grid.cols(); ++col) {
      if (!IsCoast(field.grid, land, {row, col})) continue;
      marker.points.push_back(
          ToPoint(map_, field.grid.Centre({row, col}), 100.0));
    }
  }
}

void MarkerPainter::PaintField(const kg_compiler::WorkField& field,
                               const double time_s) {
  const Grid& grid = field.field.grid;
  Marker& marker = Add("currents", Marker::LINE_LIST);
  marker.scale.x = 1500.0 * size_;
  marker.color = Colour(0.15, 0.25, 0.6, 0.8);
  const double width_m = WidthOf(grid, map_);
  const double step_m = std::min(kArrowSpacing_m, width_m / 30.0);
  const int step = std::max(
      1, static_cast<int>(step_m * grid.cols() / std::max(1.0, width_m)));
  const double arrow_s =
      kArrowSeconds * step_m / kArrowSpacing_m *
      std::min(1.0, kLongestArrow_mps / Strongest_mps(field.field));
  for (int row = step / 2; row < grid.rows(); row += step) {
    for (int col = step / 2; col < grid.cols(); col += step) {
      const auto velocity = field.field.Sample(
          {static_cast<double>(row), static_cast<double>(col)}, time_s);
      if (!velocity) continue;
      geometry_msgs::Point tail = ToPoint(map_, grid.Centre({row, col}), 150.0);
      geometry_msgs::Point head = tail;
      head.x += velocity->east_mps * arrow_s;
      head.y += velocity->north_mps * arrow_s;
      marker.points.push_back(tail);
      marker.points.push_back(head);
    }
  }
}

void MarkerPainter::PaintTrack(
    const std::vector<kg_compiler::TimedPoint>& track, const double z_m,
    Marker* marker) const {
  for (const kg_compiler::TimedPoint& point : track) {
    marker->points.push_back(ToPoint(map_, point.position, z_m));
  }
}

void MarkerPainter::PaintNavGraph(const kg_engine::AgentGraph& graph) {
  const std::string name = "nav_graph/" + graph.agent;
  Marker& nodes = Add(name, Marker::POINTS);
  nodes.scale.x = nodes.scale.y = 6000.0 * size_;
  nodes.color = Colour(0.2, 0.2, 0.2, 0.9);
  for (const kg_compiler::Waypoint& waypoint : graph.graph->waypoints) {
    nodes.points.push_back(ToPoint(map_, waypoint.position, 350.0));
  }
  Marker& lines = Add(name, Marker::LINE_LIST);
  lines.scale.x = 700.0 * size_;
  lines.color = Colour(0.4, 0.4, 0.4, 0.35);
  for (const auto* edges : {&graph.graph->edges, &graph.graph->inner_edges}) {
    for (const kg_compiler::TraverseEdge& edge : *edges) {
      const auto& track = edge.flight.track;
      for (std::size_t i = 1; i < track.size(); ++i) {
        lines.points.push_back(ToPoint(map_, track[i - 1].position, 320.0));
        lines.points.push_back(ToPoint(map_, track[i].position, 320.0));
      }
    }
  }
}

void MarkerPainter::PaintStaging(const kg_engine::AgentGraph& graph) {
  for (std::size_t i = 0; i < graph.staging.size(); ++i) {
    if (!graph.staging[i]) continue;
    Marker& marker = Add("staging/" + graph.agent, Marker::LINE_STRIP);
    marker.scale.x = 2500.0 * size_;
    marker.color = Colour(0.6, 0.1, 0.8, 1.0);
    PaintTrack(graph.graph->edges[i].flight.track, 450.0, &marker);
  }
}

void MarkerPainter::PaintCandidates(
    const kg_selector::AgentCandidates& candidates) {
  for (const kg_selector::Pathlet& pathlet : candidates.found.pathlets) {
    Marker& marker = Add("candidates/" + candidates.agent, Marker::LINE_STRIP);
    marker.scale.x = 1500.0 * size_;
    marker.color = Colour(0.2, 0.5, 1.0, 0.4);
    PaintTrack(pathlet.track, 400.0, &marker);
  }
}

void MarkerPainter::PaintAssignment(
    const kg_selector::PathAssignment& assignment) {
  const std::string name = "assigned/" + assignment.pathlet.agent;
  Marker& marker = Add(name, Marker::LINE_STRIP);
  marker.scale.x = 5000.0 * size_;
  marker.color = Colour(0.0, 1.0, 0.0, 1.0);
  PaintTrack(assignment.pathlet.track, 460.0, &marker);
  Marker& stops = Add(name, Marker::POINTS);
  stops.scale.x = stops.scale.y = 14000.0 * size_;
  stops.color = Colour(0.0, 0.6, 0.0, 1.0);
  for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
    for (const kg_selector::Stop& stop : visit.via) {
      stops.points.push_back(ToPoint(map_, stop.position, 465.0));
    }
  }
}

void MarkerPainter::PaintAgents(
    const std::map<std::string, kg_engine::AgentPose>& poses,
    const Grid& grid) {
  const double size_m = WidthOf(grid, map_) / kAgentsAcross;
  for (const auto& [id, pose] : poses) {
    // Compass heading to half the yaw (from east).
    const double half_rad = 0.5 * (kg_base::kPi / 2.0 - pose.heading_rad);
    Marker& arrow = Add("agents", Marker::ARROW);
    arrow.pose.position = ToPoint(map_, pose.position, 430.0);
    arrow.pose.orientation.w = std::cos(half_rad);
    arrow.pose.orientation.z = std::sin(half_rad);
    arrow.scale.x = size_m;
    arrow.scale.y = 0.35 * size_m;
    arrow.scale.z = 20.0;
    arrow.color = Colour(1.0, 1.0, 1.0, 1.0);
    Marker& name = Add("agents", Marker::TEXT_VIEW_FACING);
    name.text = id;
    name.pose.position = ToPoint(map_, pose.position, 480.0);
    name.pose.position.x -= 1.8 * size_m;
    name.scale.z = size_m;
    name.color = Colour(1.0, 1.0, 1.0, 1.0);
  }
}

void MarkerPainter::PaintWarnings(
    const std::vector<kg_compiler::FactWarning>& warnings, const Grid& grid) {
  const double size_m = WidthOf(grid, map_) / kAgentsAcross;
  std::map<std::pair<double, double>, int> texts_at;
  for (const kg_compiler::FactWarning& warning : warnings) {
    kg_base::LonLat place = warning.place.value_or(grid.Middle());
    place.lon_deg = std::clamp(place.lon_deg, grid.west_deg(), grid.east_deg());
    place.lat_deg =
        std::clamp(place.lat_deg, grid.south_deg(), grid.north_deg());
    Marker& text = Add("warnings", Marker::TEXT_VIEW_FACING);
    text.text = warning.label;
    text.pose.position = ToPoint(map_, place, 490.0);
    // Texts of the same place stand below each other.
    text.pose.position.y -= size_m * texts_at[{place.lon_deg, place.lat_deg}]++;
    text.scale.z = 0.7 * size_m;
    text.color = Colour(1.0, 0.3, 0.0, 1.0);
  }
}

visualization_msgs::MarkerArray MarkerPainter::Take() {
  // rviz rejects line markers without points: omit them.
  visualization_msgs::MarkerArray painted;
  Marker erase;
  erase.header.frame_id = kMapFrame;
  erase.action = Marker::DELETEALL;
  painted.markers.push_back(erase);
  for (Marker& marker : markers_.markers) {
    const bool needs_points = marker.type != Marker::CYLINDER &&
                              marker.type != Marker::ARROW &&
                              marker.type != Marker::TEXT_VIEW_FACING;
    if (needs_points && marker.points.empty()) continue;
    painted.markers.push_back(std::move(marker));
  }
  markers_.markers.clear();
  return painted;
}

}  // namespace kg_ros
