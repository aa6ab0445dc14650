// Lets other threads have work done on the thread that calls ROS callbacks, in
// turn with them: what it decides needs no lock.

#ifndef KG_ROS_BASE_MAIN_THREAD_H_
#define KG_ROS_BASE_MAIN_THREAD_H_

#include <atomic>
#include <functional>

#include "ros/callback_queue_interface.h"

namespace kg_ros {

class MainThread {
 public:
  // `queue` is the one that the thread calls; it must outlive this.
  explicit MainThread(ros::CallbackQueueInterface* queue) : queue_(queue) {}

  // True when `work` has been done. False if it did not begin within
  // `patience_s` or before Close(): then it never will. From any thread but
  // that one.
  bool Do(std::function<void()> work, double patience_s);

  // Nothing begins any more. From that thread only, so that nothing is under
  // way.
  void Close() { is_closed_ = true; }

 private:
  ros::CallbackQueueInterface* const queue_;
  std::atomic<bool> is_closed_{false};
};

}  // namespace kg_ros

#endif  // KG_ROS_BASE_MAIN_THREAD_H_
