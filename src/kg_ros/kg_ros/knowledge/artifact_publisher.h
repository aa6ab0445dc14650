// Publishes compilations: tensors, work fields, seam rules, coordination rules.
//
// A raster is published when its hash is new; a new subscriber receives all
// current ones. Rules are published with every cycle and reference their
// rasters by hash, so that a planner never mixes world versions.

#ifndef KG_ROS_KNOWLEDGE_ARTIFACT_PUBLISHER_H_
#define KG_ROS_KNOWLEDGE_ARTIFACT_PUBLISHER_H_

#include <cstdint>
#include <map>
#include <string>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_msgs/MissionTensor.h"
#include "kg_msgs/WorkField.h"
#include "ros/node_handle.h"
#include "ros/publisher.h"
#include "ros/single_subscriber_publisher.h"

namespace kg_ros {

class ArtifactPublisher {
 public:
  explicit ArtifactPublisher(const ros::NodeHandle& node);

  void Publish(const kg_compiler::Compilation& compilation,
               std::uint64_t cycle);

  // Whether a planner for this agent, and a selector, are connected.
  bool HasPlanner(const std::string& agent_id) const;
  bool HasSelector() const;

 private:
  struct AgentTopics {
    ros::Publisher tensors;
    ros::Publisher seam_rules;
    std::map<int, kg_msgs::MissionTensorConstPtr> current;  // By window.
  };

  AgentTopics& TopicsOf(const std::string& agent_id);
  void PublishTensors(const kg_compiler::Compilation& compilation);
  void PublishFields(const kg_compiler::Compilation& compilation);
  void PublishRules(const kg_compiler::Compilation& compilation,
                    std::uint64_t cycle);

  ros::NodeHandle node_;
  ros::Publisher fields_;
  ros::Publisher coordination_;
  std::map<int, kg_msgs::WorkFieldConstPtr> current_fields_;  // By window.
  std::map<std::string, AgentTopics> agents_;                 // By ex:id.
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_ARTIFACT_PUBLISHER_H_
