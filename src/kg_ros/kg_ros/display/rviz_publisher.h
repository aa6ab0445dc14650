// Keeps rviz and tf up to date: layers, paths, markers, frames.

#ifndef KG_ROS_DISPLAY_RVIZ_PUBLISHER_H_
#define KG_ROS_DISPLAY_RVIZ_PUBLISHER_H_

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/geo/map_projection.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/explain/fact_warnings.h"
#include "kg_engine/display/agent_view.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_ros/display/layer_publisher.h"
#include "kg_selector/team/agent_candidates.h"
#include "kg_selector/team/committed_plan.h"
#include "ros/node_handle.h"
#include "ros/publisher.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

namespace kg_ros {

class RvizPublisher {
 public:
  explicit RvizPublisher(const ros::NodeHandle& node);

  // Sets the compilation to show. All layers are of `window`, clamped to the
  // compiled windows.
  void Show(std::shared_ptr<const kg_compiler::Compilation> compilation,
            int window);
  void ShowPlan(const kg_selector::CommittedPlan& plan);
  void ShowFleet(const kg_engine::FleetState& fleet);
  // Stored until the next Refresh().
  void Keep(const kg_engine::AgentGraph& graph);
  void Keep(const kg_selector::AgentCandidates& candidates);
  void Keep(const std::vector<kg_compiler::FactWarning>& warnings);
  // Shows data received and agent positions changed since Show().
  void Refresh();

 private:
  void PublishMapFrame(kg_base::LonLat centre);
  void ShowMarkers();
  template <typename Message>
  ros::Publisher& Latched(const std::string& topic);

  ros::NodeHandle node_;
  kg_base::MapProjection map_{kg_base::LonLat{}};
  tf2_ros::TransformBroadcaster frames_;
  tf2_ros::StaticTransformBroadcaster static_frames_;
  ros::Publisher markers_;
  LayerPublisher layers_;
  std::map<std::string, ros::Publisher> publishers_;  // By topic.
  std::map<std::pair<std::string, int>, kg_engine::AgentGraph> graphs_;
  std::map<std::string, kg_selector::AgentCandidates> candidates_;
  std::vector<kg_compiler::FactWarning> warnings_;
  kg_engine::Scene scene_;
};

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_RVIZ_PUBLISHER_H_
