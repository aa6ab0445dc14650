// Output of `make bench`: one line per target, with the goal and the measured
// value.

#ifndef KG_BASE_COMMON_TESTING_BENCH_REPORT_H_
#define KG_BASE_COMMON_TESTING_BENCH_REPORT_H_

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/stopwatch.h"

namespace kg_base {

struct BenchTarget {
  int number = 0;    // Number in the table of docs/performance.md.
  std::string what;  // Measured quantity and baseline.
  double goal = 0.0;
  bool at_least = true;  // false: at most.
  std::string unit;      // "x", "%", "ms", ...
};

// Prints the target's line. True if it is met.
inline bool Report(const BenchTarget& target, double measured) {
  const bool met =
      target.at_least ? measured >= target.goal : measured <= target.goal;
  std::printf("target %-2d %-58s goal %s %-8g %-4s measured %-10.4g %-4s %s\n",
              target.number, target.what.c_str(),
              target.at_least ? ">=" : "<=", target.goal, target.unit.c_str(),
              measured, target.unit.c_str(), met ? "met" : "missed");
  std::fflush(stdout);
  return met;
}

inline double Median(std::vector<double> values) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename Work>
double Seconds(const Work& work) {
  const Stopwatch watch;
  work();
  return watch.Elapsed_s();
}

template <typename Work>
double Milliseconds(const Work& work) {
  return 1000.0 * Seconds(work);
}

// Median of the ratios seconds(b) / seconds(a), with a and b timed alternately,
// so that other load affects both equally. `seconds` times one of them.
template <typename Clock, typename A, typename B>
double PairedRatioBy(const Clock& seconds, int rounds, const A& a, const B& b) {
  std::vector<double> ratios;
  for (int i = 0; i < rounds; ++i) {
    const double a_s = seconds(a);
    ratios.push_back(seconds(b) / a_s);
  }
  return Median(std::move(ratios));
}
template <typename A, typename B>
double PairedRatio(int rounds, const A& a, const B& b) {
  return PairedRatioBy([](const auto& work) { return Seconds(work); }, rounds,
                       a, b);
}

}  // namespace kg_base

#endif  // KG_BASE_COMMON_TESTING_BENCH_REPORT_H_
