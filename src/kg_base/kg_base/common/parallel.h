// A parallel loop over independent steps, on all cores.

#ifndef KG_BASE_COMMON_PARALLEL_H_
#define KG_BASE_COMMON_PARALLEL_H_

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace kg_base {

// Calls work(0) ... work(count - 1), each once, in any order and from several
// threads. Returns when all have ended; rethrows the exception of one of them,
// if any. After an exception the remaining steps may be skipped.
template <typename Work>
void ForEachInParallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::future<void>> workers;
  while (workers.size() + 1 < std::min(cores, count)) {
    workers.push_back(std::async(std::launch::async, take_turns));
  }
  std::future<void> own = std::async(std::launch::deferred, take_turns);
  own.wait();
  for (std::future<void>& worker : workers) worker.wait();
  own.get();
  for (std::future<void>& worker : workers) worker.get();
}

}  // namespace kg_base

#endif  // KG_BASE_COMMON_PARALLEL_H_
