// Team Orienteering, sets 1 to 4, against the published values (target 12): the
// exact mode at 0.5 s and 2 s of processor time per instance, and the other
// modes. `--quick`: every 40th instance, at 0.05 s. Prints a notice and
// measures nothing if the data is missing.
//
//   team_orienteering_bench [--quick]

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <sstream>
#include <string>

#include "kg_base/common/testing/bench_report.h"
#include "kg_selector/orienteering/top_report.h"
#include "kg_selector/team/team_modes.h"

namespace kg_selector {
namespace {

struct BenchData {
  std::string instances;
  std::string references;
};

BenchData FindData() {
  const char* given = std::getenv("KG_SHARED_DATA");
  const std::string folder =
      std::string(given != nullptr ? given : "../shared/data") + "/top";
  return {folder + "/instances", folder + "/reference_values.txt"};
}

double MeasureShare(const BenchData& data, const TeamTourOptions& options,
                    std::size_t step) {
  std::ostringstream lines;
  TopScore all;
  for (const auto& [set, score] :
       RunTop(data.instances, data.references, options, &lines, step)) {
    all.Add(score);
  }
  return all.share();
}

void CompareModes(const BenchData& data, double seconds, std::size_t step) {
  for (const TeamMode& mode : TeamModes()) {
    if (mode.plan_tours == PlanToursExactly) continue;
    TeamTourOptions options;
    options.planner = mode.plan_tours;
    options.seconds = seconds;
    std::printf("%s: %.2f %% of the published values at %g s\n", mode.name,
                MeasureShare(data, options, step), seconds);
    std::fflush(stdout);
  }
}

void Measure(const BenchData& data, double seconds, std::size_t step,
             double goal) {
  TeamTourOptions options;
  options.seconds = seconds;
  char what[64];
  std::snprintf(what, sizeof what, "Team Orienteering, exact, %g s an instance",
                seconds);
  kg_base::Report({12, what, goal, true, "%"},
                  MeasureShare(data, options, step));
}

void Run(const BenchData& data, bool quick) {
  const std::size_t step = quick ? 40 : 1;
  CompareModes(data, quick ? 0.05 : 0.5, quick ? step : 10);
  Measure(data, quick ? 0.05 : 0.5, step, 99.5);
  Measure(data, quick ? 0.1 : 2.0, step, 99.8);
}

}  // namespace
}  // namespace kg_selector

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const kg_selector::BenchData data = kg_selector::FindData();
  if (!std::filesystem::exists(data.instances)) {
    std::printf("target 12 skipped: no benchmark data at %s\n",
                data.instances.c_str());
    return 0;
  }
  try {
    kg_selector::Run(data, quick);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "team_orienteering_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
