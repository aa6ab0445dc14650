// For tests: the W3C suites in test_data/w3c, and those in ../shared/data/w3c
// next to the project (or in $KG_SHARED_DATA/w3c) if present. Tests run in the
// package's source folder.

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

// Runs a suite, and reports its tests that fail.
inline ConformanceCount RunSuite(const std::filesystem::path& folder,
                                 const KnownDeviations& deviations) {
  const auto tests = RunConformance(
      folder, [](const ConformanceTest&) {}, deviations);
  std::map<std::string, int> groups;
  for (const ConformanceTest& test : tests) {
    EXPECT_NE(test.outcome, ConformanceTest::Outcome::kFailed)
        << test.group << " " << test.name << " (" << test.kind
        << "): " << test.message;
    ++groups[test.group];
  }
  for (const auto& [group, count] : groups) {
    std::cout << group << ": " << count << " tests\n";
  }
  return CountOutcomes(tests);
}

// Expects that every test of the suite passes, and that there are at least
// `least`.
inline void ExpectSuitePasses(const std::string& suite, int least) {
  const std::filesystem::path folder = W3cFolder() / suite;
  if (!std::filesystem::is_directory(folder)) {
    GTEST_SKIP() << "W3C suite not found: " << folder;
  }
  const ConformanceCount count = RunSuite(folder, {});
  EXPECT_EQ(count.not_run, 0);
  EXPECT_GE(count.passed, least);
}

// Expects these outcomes, and no failed test, of a suite in test_data/w3c.
inline void ExpectOutcomes(const std::string& suite, int passed, int deviating,
                           int not_run) {
  const std::filesystem::path folder = "test_data/w3c";
  KnownDeviations deviations = ReadDeviations(folder / "deviations.txt");
  const ConformanceCount count = RunSuite(folder / suite, deviations);
  EXPECT_EQ(count.passed, passed);
  EXPECT_EQ(count.deviating, deviating);
  EXPECT_EQ(count.not_run, not_run);
}

}  // namespace kg_engine

#endif  // KG_ENGINE_CONFORMANCE_TESTING_W3C_SUITE_H_
