// Elapsed time [s] by a monotonic clock.

#ifndef KG_BASE_COMMON_STOPWATCH_H_
#define KG_BASE_COMMON_STOPWATCH_H_

#include <chrono>

namespace kg_base {

// Runs from its construction.
class Stopwatch {
 public:
  double Elapsed_s() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }
  // Elapsed time [s]; restarts from 0.
  double Lap_s() {
    const Clock::time_point now = Clock::now();
    const double lap_s = std::chrono::duration<double>(now - begin_).count();
    begin_ = now;
    return lap_s;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace kg_base

#endif  // KG_BASE_COMMON_STOPWATCH_H_
