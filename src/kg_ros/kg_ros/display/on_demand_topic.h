// A topic that is never behind and costs nothing while nobody listens: its
// message is made when somebody does, kept until something else is to be
// shown, and sent to whoever comes later (as a latched topic would).

#ifndef KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_
#define KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_

#include <functional>
#include <optional>
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
  OnDemandTopic(ros::NodeHandle node, const std::string& name)
      : publisher_(node.advertise<Message>(
            name, 1, [this](const ros::SingleSubscriberPublisher& subscriber) {
              if (make_) subscriber.publish(Current());
            })) {}
  OnDemandTopic(const OnDemandTopic&) = delete;
  OnDemandTopic& operator=(const OnDemandTopic&) = delete;

  // From now on shows what `make` makes. Equal keys: the message would be the
  // same, and is not sent again.
  void Offer(const std::string& key, std::function<Message()> make) {
    make_ = std::move(make);
    if (key == key_) return;
    key_ = key;
    current_.reset();
    if (publisher_.getNumSubscribers() > 0) publisher_.publish(Current());
  }

 private:
  const Message& Current() {
    if (!current_) current_ = make_();
    return *current_;
  }

  std::string key_;
  std::function<Message()> make_;
  std::optional<Message> current_;
  ros::Publisher publisher_;
};

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_ON_DEMAND_TOPIC_H_
