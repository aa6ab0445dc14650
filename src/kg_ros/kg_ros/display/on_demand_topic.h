// A latched topic without cost while it has no subscribers: its message is made
// on the first subscription and kept until the content changes.

#ifndef KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_
#define KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_

#include <functional>
#include <string>
#include <utility>

#include "ros/node_handle.h"
#include "ros/publisher.h"
#include "ros/single_subscriber_publisher.h"

namespace kg_ros {

// Single-threaded: use from the thread that serves the node handle's callbacks.
template <typename Message>
class OnDemandTopic {
 public:
  OnDemandTopic(const ros::NodeHandle& node, const std::string& name)
      : node_(node), name_(name) {
    Advertise();
  }
  OnDemandTopic(const OnDemandTopic&) = delete;
  OnDemandTopic& operator=(const OnDemandTopic&) = delete;

  // Sets the content to the result of `make`. Equal keys mean equal messages,
  // which are not sent again.
  void Offer(const std::string& key, std::function<Message()> make) {
    make_ = std::move(make);
    if (key == key_) return;
    key_ = key;
    if (publisher_.getNumSubscribers() > 0) {
      Publish();
    } else if (is_published_) {
      Advertise();
    }
  }

 private:
  // Advertises again, which discards the latched message.
  void Advertise() {
    publisher_.shutdown();
    is_published_ = false;
    const auto greet = [this](const ros::SingleSubscriberPublisher&) {
      if (make_ && !is_published_) Publish();
    };
    publisher_ = node_.advertise<Message>(name_, 1, greet, {}, {}, true);
  }
  void Publish() {
    is_published_ = true;
    publisher_.publish(make_());
  }

  ros::NodeHandle node_;
  std::string name_;
  std::string key_;
  std::function<Message()> make_;
  // True if the current message was published since advertising.
  bool is_published_ = false;
  ros::Publisher publisher_;
};

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_
