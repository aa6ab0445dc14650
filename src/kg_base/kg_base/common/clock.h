// The time of day, for logs and provenance. Durations are measured with a
// Stopwatch (stopwatch.h) instead.

#ifndef KG_BASE_COMMON_CLOCK_H_
#define KG_BASE_COMMON_CLOCK_H_

#include <chrono>

namespace kg_base {

// Unix seconds, now.
inline double Now_s() {
  return std::chrono::duration<double>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace kg_base

#endif  // KG_BASE_COMMON_CLOCK_H_
