// A latched topic that costs nothing while nobody listens: its message is made
// when somebody does, and kept until something else is to be shown.

#ifndef KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_
#define KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_

#include <functional>
#include <string>
#include <utility>

#include "ros/node_handle.h"
#include "ros/publisher.h"
#include "ros/single_subscriber_publisher.h"

namespace kg_ros {

// Used by one thread: the one that serves the node handle's callbacks.
template <typename Message>
class OnDemandTopic {
 public:
  OnDemandTopic(const ros::NodeHandle& node, const std::string& name)
      : node_(node), name_(name) {
    Advertise();
  }
  OnDemandTopic(const OnDemandTopic&) = delete;
  OnDemandTopic& operator=(const OnDemandTopic&) = delete;

  // From now on shows what `make` makes. Equal keys: the message would be the
  // same, and is not sent again.
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
  // Anew, so that what was latched is forgotten.
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
  bool is_published_ = false;  // What `make_` makes, since it was advertised.
  ros::Publisher publisher_;
};

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_
