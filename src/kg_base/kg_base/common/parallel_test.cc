#include "kg_base/common/parallel.h"

#include <stdexcept>

#include "gtest/gtest.h"

namespace kg_base {
namespace {

TEST(ParallelTest, EveryStepIsTakenOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 1000U}) {
    std::vector<std::atomic<int>> taken(count);
    ForEachInParallel(count, [&](std::size_t i) { ++taken[i]; });
    for (const std::atomic<int>& times : taken) EXPECT_EQ(times, 1);
  }
}

TEST(ParallelTest, ThrowsWhatAStepThrew) {
  for (const std::size_t bad : {0U, 7U, 99U}) {
    const auto work = [&](std::size_t i) {
      if (i == bad) throw std::logic_error("bad");
    };
    EXPECT_THROW(ForEachInParallel(100, work), std::logic_error);
  }
}

}  // namespace
}  // namespace kg_base
