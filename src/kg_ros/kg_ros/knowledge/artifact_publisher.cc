#include "kg_ros/knowledge/artifact_publisher.h"

#include <utility>
#include <vector>

#include "boost/make_shared.hpp"
#include "kg_msgs/CoordinationRules.h"
#include "kg_msgs/SeamRules.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;
using kg_compiler::Layer;

const std::vector<Layer>& PlannersLayers() {
  static const std::vector<Layer> layers = {Layer::kFused, Layer::kFeasibility,
                                            Layer::kAttenuation};
  return layers;
}

template <typename Messages>
void SendAll(const Messages& current,
             const ros::SingleSubscriberPublisher& subscriber) {
  for (const auto& [window, message] : current) subscriber.publish(*message);
}

std::string IdOf(const Compilation& compilation, const std::string& iri) {
  const kg_mission::Agent* agent = compilation.mission.FindAgent(iri);
  return agent == nullptr ? "" : agent->id;
}

}  // namespace

ArtifactPublisher::ArtifactPublisher(const ros::NodeHandle& node)
    : node_(node) {
  fields_ = node_.advertise<kg_msgs::WorkField>(
      kWorkFieldsTopic, kAllWindows,
      [this](const ros::SingleSubscriberPublisher& subscriber) {
        SendAll(current_fields_, subscriber);
      });
  coordination_ = node_.advertise<kg_msgs::CoordinationRules>(
      kCoordinationTopic, 1, kLatched);
}

ArtifactPublisher::AgentTopics& ArtifactPublisher::TopicsOf(
    const std::string& agent_id) {
  AgentTopics& topics = agents_[agent_id];
  if (topics.tensors) return topics;
  topics.tensors = node_.advertise<kg_msgs::MissionTensor>(
      AgentTopic(agent_id, kTensors), kAllWindows,
      [this, agent_id](const ros::SingleSubscriberPublisher& subscriber) {
        SendAll(agents_[agent_id].current, subscriber);
      });
  topics.seam_rules = node_.advertise<kg_msgs::SeamRules>(
      AgentTopic(agent_id, kSeamRules), 1, kLatched);
  return topics;
}

void ArtifactPublisher::Publish(const Compilation& compilation,
                                const std::uint64_t cycle) {
  PublishFields(compilation);
  PublishTensors(compilation);
  PublishRules(compilation, cycle);
}

void ArtifactPublisher::PublishFields(const Compilation& compilation) {
  std::map<int, kg_msgs::WorkFieldConstPtr> current;
  for (const auto& field : compilation.fields) {
    const auto known = current_fields_.find(field->window);
    if (known != current_fields_.end() && known->second->hash == field->hash) {
      current[field->window] = known->second;
      continue;
    }
    const auto message = boost::make_shared<kg_msgs::WorkField>(
        ToMessage(*field, compilation.world_version));
    message->header.stamp = ros::Time::now();
    current[field->window] = message;
    fields_.publish(kg_msgs::WorkFieldConstPtr(message));
  }
  current_fields_ = std::move(current);
}

void ArtifactPublisher::PublishTensors(const Compilation& compilation) {
  std::map<std::string, std::map<int, kg_msgs::MissionTensorConstPtr>> current;
  for (const auto& tensor : compilation.tensors) {
    const std::string id = IdOf(compilation, tensor->agent_iri);
    AgentTopics& topics = TopicsOf(id);
    const auto known = topics.current.find(tensor->window);
    if (known != topics.current.end() && known->second->hash == tensor->hash) {
      current[id][tensor->window] = known->second;
      continue;
    }
    const auto message = boost::make_shared<kg_msgs::MissionTensor>(
        ToMessage(*tensor, id, compilation.world_version, PlannersLayers()));
    message->header.stamp = ros::Time::now();
    current[id][tensor->window] = message;
    topics.tensors.publish(kg_msgs::MissionTensorConstPtr(message));
  }
  for (auto& [id, topics] : agents_) topics.current = std::move(current[id]);
}

void ArtifactPublisher::PublishRules(const Compilation& compilation,
                                     const std::uint64_t cycle) {
  kg_msgs::CoordinationRules team =
      ToMessage(CoordinationOf(compilation, cycle));
  team.header.stamp = ros::Time::now();
  coordination_.publish(team);
  for (const kg_compiler::SeamRules& rules : compilation.rules) {
    kg_msgs::SeamRules message = ToMessage(rules, cycle);
    message.header.stamp = ros::Time::now();
    TopicsOf(rules.agent_id).seam_rules.publish(message);
  }
}

bool ArtifactPublisher::HasPlanner(const std::string& agent_id) const {
  const auto topics = agents_.find(agent_id);
  return topics != agents_.end() &&
         topics->second.tensors.getNumSubscribers() > 0;
}

bool ArtifactPublisher::HasSelector() const {
  return coordination_.getNumSubscribers() > 0;
}

}  // namespace kg_ros
