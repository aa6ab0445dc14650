// Benchmark: targets 5, 6 and 7, flights in currents.
//
//   traversal_bench [--quick]
//
// 5: flights against closed forms of 5 flows. 6: every claim on two real files
// of currents (if present next to the repository), reintegrated by an
// independent integrator. 7: one-to-all against this folder's Dijkstra with 32
// neighbours on the same grid, and the errors of both; also limited to one day.

#include <cstdio>
#include <cstring>

#include "kg_base/common/testing/bench_report.h"
#include "kg_compiler/traversal/testing/seam_quality.h"

namespace kg_compiler {
namespace {

using kg_base::Median;
using kg_base::PairedRatio;
using kg_base::Report;
using kg_base::Seconds;

constexpr double kPercent = 100.0;

void ReportAccuracy(bool quick) {
  double mean = 0.0, most = 0.0;
  int missed = 0, claimed = 0;
  for (const ClosedForm& form : ClosedForms()) {
    const SeamError error = AgainstOptimum(form, quick ? 20 : 200, 1);
    std::printf(
        "          %-28s %3d targets: mean %.4f %%, max %.4f %%, least "
        "%.4f %%, missed %d, claimed wrongly %d\n",
        form.name.c_str(), error.targets, kPercent * error.mean,
        kPercent * error.most, kPercent * error.least, error.missed,
        error.claimed);
    mean = std::max(mean, error.mean);
    most = std::max(most, error.most);
    missed += error.missed;
    claimed += error.claimed;
  }
  Report({5, "seam accuracy: mean above the optimum, worst of 5 flows", 0.05,
          false, "%"},
         kPercent * mean);
  Report({5, "seam accuracy: max above the optimum, worst of 5 flows", 0.2,
          false, "%"},
         kPercent * most);
  Report({5, "places missed or claimed wrongly", 0.0, false, ""},
         missed + claimed);
}

void ReportTruth(bool quick) {
  SeamTruth all;
  for (const char* file : kRealFiles) {
    const std::optional<TestFlowWorld> sea = RealSea(file);
    if (!sea) {
      std::printf("          %s not found: not flown\n", file);
      continue;
    }
    // The same currents for slow and fast agents.
    for (const double cruise_mps : {0.3, 0.5, 1.0}) {
      const SeamTruth truth =
          TruthOn(*sea, cruise_mps, {quick ? 1 : 5, quick ? 5 : 1, 1});
      std::printf(
          "          %.8s %.1f m/s: %d claimed, %d infeasible, %d of "
          "%d missed, %.3f %% off, at most %.3f %% above a grid's\n",
          file, cruise_mps, truth.claimed, truth.infeasible, truth.missed,
          truth.reachable, kPercent * truth.worst, kPercent * truth.above_grid);
      all.claimed += truth.claimed;
      all.infeasible += truth.infeasible;
      all.missed += truth.missed;
      all.reachable += truth.reachable;
      all.worst = std::max(all.worst, truth.worst);
    }
  }
  if (all.reachable == 0) return;
  Report({6, "seam truth: claims that cannot be flown", 0.0, false, ""},
         all.infeasible);
  Report({6, "seam truth: missed of what can be flown to", 0.5, false, "%"},
         kPercent * all.missed / all.reachable);
  Report({6, "seam truth: claimed against flown", 0.5, false, "%"},
         kPercent * all.worst);
}

template <typename AnyReach>
double MeanError(const ClosedForm& form, const AnyReach& reach, Metres from) {
  std::mt19937 rng(2);
  const kg_base::Grid& grid = form.field.grid;
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(0.0);
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const kg_base::Cell cell{static_cast<int>(Uniform(rng, 5, 380)),
                             static_cast<int>(Uniform(rng, 5, 536))};
    const auto* found = reach.Find(static_cast<int>(grid.Index(cell)));
    const kg_base::LonLat at = grid.Centre(cell);
    if (!found) continue;
    sum +=
        found->arrival_s / form.optimum_s(from, {at.lon_deg / scale.lon_deg,
                                                 at.lat_deg / scale.lat_deg}) -
        1.0;
  }
  return sum / 200;
}

void ReportSpeed(bool quick) {
  const ClosedForm form = closed_forms::Vortex();
  const TestFlowWorld vortex(form.field);
  const Metres from{-3000.0, 2000.0};
  const VoyageRequest voyage =
      vortex.From(Glider(1.0), {OnPlane(from), 0.0, 2 * kDay_s});
  const int rounds = quick ? 1 : 7;
  std::printf(
      "          one to all, 541 x 385, vortex: fan %.4f %%, "
      "32 neighbours %.4f %% above the optimum on average\n",
      kPercent * MeanError(form, ComputeReach(voyage), from),
      kPercent * MeanError(form, GridSearch(voyage, 32), from));
  Report({7, "one to all, 541 x 385, against Dijkstra with 32 neighbours", 10.0,
          true, "x"},
         PairedRatio(
             rounds, [&] { ComputeReach(voyage); },
             [&] { GridSearch(voyage, 32); }));
  // Second part: the usual planning case, a voyage limited to one day.
  std::printf("          OMPL's RRT* is not built in: not compared\n");
  const TestFlowWorld gulf(GulfLikeFlow(1, 0, kDay_s, 10800));
  for (const double cruise_mps : {0.3, 0.5, 1.0}) {
    const VoyageRequest day =
        gulf.From(Glider(cruise_mps), {{-90.01, 25.01}, 0.0, kDay_s});
    std::vector<double> seconds;
    for (int i = 0; i < 3 * rounds; ++i) {
      seconds.push_back(Seconds([&] { ComputeReach(day); }));
    }
    std::printf(
        "          24 h at %.1f m/s: fan %.3f ms, %zu cells; 32 "
        "neighbours take %.2f times that\n",
        cruise_mps, 1e3 * Median(seconds), ComputeReach(day).cells.size(),
        PairedRatio(
            3 * rounds, [&] { ComputeReach(day); },
            [&] { GridSearch(day, 32); }));
  }
}

}  // namespace
}  // namespace kg_compiler

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  kg_compiler::ReportAccuracy(quick);
  kg_compiler::ReportTruth(quick);
  kg_compiler::ReportSpeed(quick);
  return 0;
}
