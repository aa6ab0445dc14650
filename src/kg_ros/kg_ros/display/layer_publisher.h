// Tensors and work maps for rviz, for each agent and the window in view: the
// heatmap, every layer, and WORK in colour, from the agent's position and from
// the last clicked point (rviz tool "Publish Point").

#ifndef KG_ROS_DISPLAY_LAYER_PUBLISHER_H_
#define KG_ROS_DISPLAY_LAYER_PUBLISHER_H_

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "geometry_msgs/PointStamped.h"
#include "kg_base/geo/map_projection.h"
#include "kg_engine/display/agent_view.h"
#include "kg_ros/display/on_demand_topic.h"
#include "nav_msgs/OccupancyGrid.h"
#include "ros/node_handle.h"
#include "ros/subscriber.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"
#include "visualization_msgs/Marker.h"

namespace kg_ros {

class LayerPublisher {
 public:
  explicit LayerPublisher(const ros::NodeHandle& node);

  // Sets the scene to show. Cheap without subscribers.
  void Show(kg_engine::Scene scene, const kg_base::MapProjection& map);

 private:
  struct AgentTopics {
    AgentTopics(const ros::NodeHandle& node, const std::string& agent_id);

    OnDemandTopic<nav_msgs::OccupancyGrid> heatmap;
    std::map<std::string, OnDemandTopic<nav_msgs::OccupancyGrid>> layers;
    OnDemandTopic<visualization_msgs::Marker> work;
    OnDemandTopic<visualization_msgs::Marker> work_clicked;
  };

  void HandleClick(const geometry_msgs::PointStamped& message);
  void ShowAgent(const std::string& agent_id);
  void ShowClick(const std::string& agent_id, const kg_engine::AgentView& view);

  ros::NodeHandle node_;
  tf2_ros::Buffer frames_;
  tf2_ros::TransformListener frame_listener_{frames_};
  ros::Subscriber clicks_;
  kg_engine::Scene scene_;
  kg_base::MapProjection map_{kg_base::LonLat{}};
  std::optional<kg_base::LonLat> clicked_;
  std::map<std::string, AgentTopics> agents_;  // By ex:id.
};

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_LAYER_PUBLISHER_H_
