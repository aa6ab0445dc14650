// Lines of `make bench`: one for each target, with what was wanted and what was
// measured. This package may include no other, so it has its own.

#ifndef KG_PLANNER_TESTING_BENCH_REPORT_H_
#define KG_PLANNER_TESTING_BENCH_REPORT_H_

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace kg_planner {

struct BenchTarget {
  int number = 0;    // Row of the table in docs/performance.md.
  std::string what;  // What is measured, against what.
  double goal = 0.0;
  bool at_least = true;  // Else at most.
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
double Milliseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now() - begin)
      .count();
}

}  // namespace kg_planner

#endif  // KG_PLANNER_TESTING_BENCH_REPORT_H_
