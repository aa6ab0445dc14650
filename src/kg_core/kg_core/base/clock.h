// The time of day, for logs and provenance. Durations are measured with a
// Stopwatch (stopwatch.h) instead.

#ifndef KG_CORE_BASE_CLOCK_H_
#define KG_CORE_BASE_CLOCK_H_

#include <chrono>

namespace kg_core {

// Unix seconds, now.
inline double Now_s() {
  return std::chrono::duration<double>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace kg_core

#endif  // KG_CORE_BASE_CLOCK_H_
