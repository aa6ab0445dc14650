#include "kg_ros/display/rviz_publisher.h"

#include <algorithm>
#include <cmath>

#include "GeographicLib/Geocentric.hpp"
#include "geometry_msgs/TransformStamped.h"
#include "kg_base/common/units.h"
#include "kg_ros/base/names.h"
#include "kg_ros/display/display.h"
#include "kg_ros/display/ribbon.h"
#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2/LinearMath/Quaternion.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;

geometry_msgs::Quaternion QuaternionMessage(const tf2::Quaternion& rotation) {
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

// The local east-north-up frame at a position, in the geocentric frame (REP
// 105: earth -> map).
geometry_msgs::TransformStamped EarthToMap(const kg_base::LonLat& centre) {
  std::vector<double> enu(9);  // Row-major: columns are east, north, up.
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  GeographicLib::Geocentric::WGS84().Forward(centre.lat_deg, centre.lon_deg,
                                             0.0, x_m, y_m, z_m, enu);
  tf2::Quaternion rotation;
  tf2::Matrix3x3(enu[0], enu[1], enu[2], enu[3], enu[4], enu[5], enu[6], enu[7],
                 enu[8])
      .getRotation(rotation);
  geometry_msgs::TransformStamped message;
  message.header.frame_id = kEarthFrame;
  message.child_frame_id = kMapFrame;
  message.transform.translation.x = x_m;
  message.transform.translation.y = y_m;
  message.transform.translation.z = z_m;
  message.transform.rotation = QuaternionMessage(rotation);
  return message;
}

const kg_compiler::WorkField* FieldOf(const Compilation& compilation,
                                      const int window) {
  for (const auto& field : compilation.fields) {
    if (field->window == window) return field.get();
  }
  return nullptr;
}

int Clamp(const Compilation& compilation, const int window) {
  return std::clamp(window, compilation.first_window,
                    static_cast<int>(compilation.mission.windows.size()) - 1);
}

}  // namespace

RvizPublisher::RvizPublisher(const ros::NodeHandle& node)
    : node_(node), layers_(node) {
  markers_ = node_.advertise<visualization_msgs::MarkerArray>(kMarkersTopic, 1,
                                                              kLatched);
}

template <typename Message>
ros::Publisher& RvizPublisher::Latched(const std::string& topic) {
  ros::Publisher& publisher = publishers_[topic];
  if (!publisher) publisher = node_.advertise<Message>(topic, 1, kLatched);
  return publisher;
}

void RvizPublisher::PublishMapFrame(const kg_base::LonLat centre) {
  if (map_.centre() == centre) return;
  map_ = kg_base::MapProjection(centre);
  geometry_msgs::TransformStamped transform = EarthToMap(centre);
  transform.header.stamp = ros::Time::now();
  static_frames_.sendTransform(transform);
}

void RvizPublisher::Show(std::shared_ptr<const Compilation> compilation,
                         const int window) {
  if (compilation->tensors.empty()) return;
  PublishMapFrame(compilation->tensors.front()->grid.Middle());
  scene_.window = Clamp(*compilation, window);
  scene_.compilation = std::move(compilation);
  Refresh();
}

void RvizPublisher::Refresh() {
  if (scene_.compilation == nullptr) return;
  layers_.Show(scene_, map_);
  ShowMarkers();
}

void RvizPublisher::ShowPlan(const kg_selector::CommittedPlan& plan) {
  scene_.plan = plan;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    nav_msgs::Path path = ToPath(assignment.pathlet, map_);
    path.header.stamp = ros::Time::now();
    Latched<nav_msgs::Path>(AgentTopic(assignment.pathlet.agent, kPath))
        .publish(path);
  }
}

void RvizPublisher::ShowFleet(const kg_engine::FleetState& fleet) {
  scene_.poses = fleet.poses();
  scene_.time_s = fleet.time_s();
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const auto& [id, pose] : fleet.poses()) {
    const kg_base::MapPoint point = map_.Forward(pose.position);
    tf2::Quaternion rotation;  // Compass heading to yaw from east.
    rotation.setRPY(0.0, 0.0, kg_base::kPi / 2.0 - pose.heading_rad);
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = kMapFrame;
    transform.header.stamp = ros::Time::now();
    transform.child_frame_id = BaseFrame(id);
    transform.transform.translation.x = point.x_m;
    transform.transform.translation.y = point.y_m;
    transform.transform.rotation = QuaternionMessage(rotation);
    transforms.push_back(transform);
  }
  // Sent together, so that receivers have all frames.
  frames_.sendTransform(transforms);
}

void RvizPublisher::Keep(const kg_engine::AgentGraph& graph) {
  graphs_[{graph.agent, graph.window()}] = graph;
}

void RvizPublisher::Keep(const kg_selector::AgentCandidates& candidates) {
  candidates_[candidates.agent] = candidates;
}

void RvizPublisher::Keep(
    const std::vector<kg_compiler::FactWarning>& warnings) {
  warnings_ = warnings;
}

void RvizPublisher::ShowMarkers() {
  const Compilation& compilation = *scene_.compilation;
  const int shown = scene_.window;
  const kg_compiler::WorkField* field = FieldOf(compilation, shown);
  MarkerPainter paint(map_, field ? WidthOf(field->field.grid, map_)
                                  : MarkerPainter::kMapWidth_m);
  paint.PaintConstraints(compilation.mission, shown);
  paint.PaintEvents(compilation.mission, shown);
  if (field != nullptr) {
    const kg_mission::TimeWindow& at = compilation.mission.windows[shown];
    paint.PaintLand(field->field);
    paint.PaintField(*field, 0.5 * (at.begin_s + at.end_s));
    paint.PaintAgents(scene_.poses, field->field.grid);
    paint.PaintWarnings(warnings_, field->field.grid);
  }
  for (const auto& [key, graph] : graphs_) {
    if (key.second == shown) paint.PaintNavGraph(graph);
    paint.PaintStaging(graph);
  }
  for (const auto& [id, candidates] : candidates_) {
    paint.PaintCandidates(candidates);
  }
  for (const kg_selector::PathAssignment& assignment :
       scene_.plan.assignments) {
    paint.PaintAssignment(assignment);
  }
  visualization_msgs::MarkerArray markers = paint.Take();
  for (visualization_msgs::Marker& marker : markers.markers) Flatten(&marker);
  RemoveEmptyLists(&markers);
  markers_.publish(markers);
}

}  // namespace kg_ros
