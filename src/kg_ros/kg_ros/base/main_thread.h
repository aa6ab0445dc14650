// Runs work of other threads on the thread that calls ROS callbacks, serialised
// with them, so that its decisions need no lock.

#ifndef KG_ROS_BASE_MAIN_THREAD_H_
#define KG_ROS_BASE_MAIN_THREAD_H_

#include <atomic>
#include <functional>

#include "ros/callback_queue_interface.h"

namespace kg_ros {

class MainThread {
 public:
  // `queue` is the callback queue of that thread; it must outlive this object.
  explicit MainThread(ros::CallbackQueueInterface* queue) : queue_(queue) {}

  // True when `work` has been done. False if it did not begin within
  // `patience_s` or before Close(): then it never will. May be called from any
  // other thread.
  bool Do(std::function<void()> work, double patience_s);

  // No work begins after this call. Call from the callback thread only, so that
  // none is in progress.
  void Close() { is_closed_ = true; }

 private:
  ros::CallbackQueueInterface* const queue_;
  std::atomic<bool> is_closed_{false};
};

}  // namespace kg_ros

#endif  // KG_ROS_BASE_MAIN_THREAD_H_
