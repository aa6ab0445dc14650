#include "kg_ros/base/main_thread.h"

#include <boost/make_shared.hpp>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace kg_ros {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kSlice{50};  // Poll interval for Close().

class Job : public ros::CallbackInterface {
 public:
  explicit Job(std::function<void()> work) : work_(std::move(work)) {}

  CallResult call() override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (state_ == State::kGivenUp) return Success;
      state_ = State::kBegun;
    }
    work_();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      state_ = State::kDone;
    }
    done_.notify_all();
    return Success;
  }

  // True if the work was done. Once begun, it is waited for.
  bool Await(Clock::time_point end, const std::atomic<bool>& is_closed) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (state_ != State::kDone) {
      const bool too_late = is_closed || Clock::now() >= end;
      if (too_late && state_ == State::kWaiting) {
        state_ = State::kGivenUp;
        return false;
      }
      done_.wait_for(lock, kSlice);
    }
    return true;
  }

 private:
  enum class State { kWaiting, kBegun, kDone, kGivenUp };

  const std::function<void()> work_;
  std::mutex mutex_;
  std::condition_variable done_;
  State state_ = State::kWaiting;
};

}  // namespace

bool MainThread::Do(std::function<void()> work, double patience_s) {
  if (is_closed_) return false;
  const auto job = boost::make_shared<Job>(std::move(work));
  queue_->addCallback(job);
  const auto patience = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(patience_s));
  return job->Await(Clock::now() + patience, is_closed_);
}

}  // namespace kg_ros
