// For tests: a W3C suite, if present in ../shared/data/w3c next to the project
// (or in $KG_SHARED_DATA/w3c). Tests run in the package's source folder.

#ifndef KG_ENGINE_CONFORMANCE_TESTING_W3C_SUITE_H_
#define KG_ENGINE_CONFORMANCE_TESTING_W3C_SUITE_H_

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "kg_engine/conformance/conformance.h"

namespace kg_engine {

inline std::filesystem::path W3cFolder() {
  const char* folder = std::getenv("KG_SHARED_DATA");
  return std::filesystem::path(folder != nullptr ? folder
                                                 : "../../../shared/data") /
         "w3c";
}

// Expects that every test of the suite passes, and that there are at least
// `least`.
inline void ExpectSuitePasses(const std::string& suite, int least) {
  const std::filesystem::path folder = W3cFolder() / suite;
  if (!std::filesystem::is_directory(folder)) {
    GTEST_SKIP() << "W3C suite not found: " << folder;
  }
  const auto tests = RunConformance(folder);
  std::map<std::string, int> groups;
  for (const ConformanceTest& test : tests) {
    EXPECT_EQ(test.outcome, ConformanceTest::Outcome::kPassed)
        << test.group << " " << test.name << " (" << test.kind
        << "): " << test.message;
    ++groups[test.group];
  }
  for (const auto& [group, count] : groups) {
    std::cout << group << ": " << count << " tests\n";
  }
  EXPECT_GE(CountOutcomes(tests).passed, least);
}

}  // namespace kg_engine

#endif  // KG_ENGINE_CONFORMANCE_TESTING_W3C_SUITE_H_
