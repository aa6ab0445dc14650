#include "kg_ros/base/main_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "ros/callback_queue.h"

namespace kg_ros {
namespace {

TEST(MainThreadTest, DoesAllWorkOnTheThreadThatCallsTheQueue) {
  ros::CallbackQueue queue;
  MainThread main_thread(&queue);
  std::atomic<int> left{100};
  int done = 0;  // Written by the main thread only.
  const std::thread::id here = std::this_thread::get_id();
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 25; ++k) {
        EXPECT_TRUE(main_thread.Do(
            [&] {
              EXPECT_EQ(std::this_thread::get_id(), here);
              ++done;
            },
            1e6));
        --left;
      }
    });
  }
  while (left > 0) queue.callAvailable(ros::WallDuration(0.01));
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(done, 100);
}

TEST(MainThreadTest, NeverDoesWhatWasGivenUp) {
  ros::CallbackQueue queue;
  MainThread main_thread(&queue);
  bool was_done = false;
  std::thread asking(
      [&] { EXPECT_FALSE(main_thread.Do([&] { was_done = true; }, 0.01)); });
  asking.join();
  queue.callAvailable();
  EXPECT_FALSE(was_done);
}

TEST(MainThreadTest, ReleasesWaitingCallersOnClose) {
  ros::CallbackQueue queue;
  MainThread main_thread(&queue);
  std::thread asking(
      [&] { EXPECT_FALSE(main_thread.Do([] { FAIL() << "was done"; }, 1e6)); });
  while (queue.isEmpty()) std::this_thread::yield();
  main_thread.Close();
  asking.join();
  EXPECT_FALSE(main_thread.Do([] { FAIL() << "was done"; }, 1e6));
  queue.callAvailable();
}

}  // namespace
}  // namespace kg_ros
