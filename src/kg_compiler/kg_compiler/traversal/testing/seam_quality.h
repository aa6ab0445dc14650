// For tests and benchmarks: quality of flights against closed forms and on real
// files.

#ifndef KG_COMPILER_TRAVERSAL_TESTING_SEAM_QUALITY_H_
#define KG_COMPILER_TRAVERSAL_TESTING_SEAM_QUALITY_H_

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "kg_compiler/traversal/testing/closed_forms.h"
#include "kg_compiler/traversal/testing/grid_search.h"
#include "kg_compiler/traversal/testing/test_flow_world.h"

namespace kg_compiler {

struct SeamError {
  int targets = 0;
  int missed = 0;     // Reachable places without a flight.
  int claimed = 0;    // Flights to places that are not reachable.
  double mean = 0.0;  // Relative excess over the optimum.
  double most = 0.0;
  double least = 0.0;
};

// Flights in a flow of known optimum, to `count` random places. Places within
// 0.3 % of the day limit or of the edge of a cone are not judged.
inline SeamError AgainstOptimum(const ClosedForm& form, int count,
                                unsigned seed) {
  std::mt19937 rng(seed);
  const TestFlowWorld sea(form.field);
  const Metres from{-3000.0, 2000.0};
  const VoyageRequest voyage =
      sea.From(Glider(1.0), {OnPlane(from), 0.0, kDay_s});
  const ReachMap reach = ComputeReach(voyage);
  SeamError error;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const Metres to{Uniform(rng, -28e3, 28e3), Uniform(rng, -20e3, 20e3)};
    const double optimum_s = form.optimum_s(from, to);
    const double slower_s = form.optimum_s(
        from,
        {from.x + 1.003 * (to.x - from.x), from.y + 1.003 * (to.y - from.y)});
    const auto flight = Traverse(voyage, reach, OnPlane(to));
    if (!std::isfinite(optimum_s)) {
      error.claimed += flight.has_value();
      continue;
    }
    ++error.targets;
    if (!flight) {
      error.missed += std::isfinite(slower_s);
      continue;
    }
    const double above = flight->travel_s / optimum_s - 1.0;
    sum += above;
    error.most = std::max(error.most, above);
    error.least = std::min(error.least, above);
  }
  error.mean = sum / std::max(1, error.targets - error.missed);
  return error;
}

struct SeamTruth {
  int claimed = 0;
  int infeasible = 0;       // Claimed, but cannot be flown.
  int reachable = 0;        // Reached by some flown path.
  int missed = 0;           // ... without a claim.
  double worst = 0.0;       // Largest relative error of a claimed time.
  double above_grid = 0.0;  // Relative excess over the best flown grid path.
};

// Takes every `every`-th cell centre that the fan or a grid search of 16 or 32
// neighbours reaches from one place; an independent integrator flies it again.
inline void AddTruth(const VoyageRequest& voyage, const TestFlowWorld& sea,
                     int every, SeamTruth* truth) {
  const kg_base::Grid& grid = sea.field.grid;
  const ReachMap reach = ComputeReach(voyage);
  const GridReach peers[] = {GridSearch(voyage, 16), GridSearch(voyage, 32)};
  const Refly refly(sea, voyage.motion);
  std::set<int> cells;
  for (const ReachedCell& cell : reach.cells) cells.insert(cell.index);
  for (const GridReach& peer : peers) {
    for (const GridReachedCell& cell : peer.cells) cells.insert(cell.index);
  }
  for (const int index : cells) {
    if (index % every != 0) continue;
    const kg_base::LonLat to =
        grid.Centre({index / grid.cols(), index % grid.cols()});
    const auto flight = Traverse(voyage, reach, to);
    double flown_s = std::numeric_limits<double>::infinity();
    for (const GridReach& peer : peers) {
      if (!peer.Find(index)) continue;
      FlownPath track;
      for (const kg_base::LonLat at :
           peer.Track(grid, voyage.departure.from, index)) {
        track.track.push_back({at, 0.0});
      }
      const auto again_s = refly.Fly(track);
      if (again_s && *again_s <= kDay_s) flown_s = std::min(flown_s, *again_s);
    }
    truth->reachable += flight || std::isfinite(flown_s);
    truth->missed += !flight && std::isfinite(flown_s);
    if (!flight) continue;
    ++truth->claimed;
    const auto again_s = refly.Fly(*flight);
    if (!again_s || !(*again_s <= 1.005 * kDay_s)) {
      ++truth->infeasible;
      continue;
    }
    truth->worst =
        std::max(truth->worst, std::abs(flight->travel_s / *again_s - 1.0));
    truth->above_grid =
        std::max(truth->above_grid, flight->travel_s / flown_s - 1.0);
  }
}

struct TruthSample {
  int sources = 1;
  int every = 1;  // One cell in `every` is tested.
  unsigned seed = 1;
};

inline SeamTruth TruthOn(const TestFlowWorld& sea, double cruise_mps,
                         const TruthSample& sample) {
  std::mt19937 rng(sample.seed);
  const kg_base::Grid& grid = sea.field.grid;
  SeamTruth truth;
  for (int i = 0; i < sample.sources;) {
    const kg_base::GridPoint at{Uniform(rng, 2, grid.rows() - 3),
                                Uniform(rng, 2, grid.cols() - 3)};
    const kg_base::LonLat from = grid.Position(at);
    if (!sea.open[grid.Index(*grid.CellAt(from))]) continue;
    AddTruth(sea.From(Glider(cruise_mps), {from, 0.0, kDay_s}), sea,
             sample.every, &truth);
    ++i;
  }
  return truth;
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TESTING_SEAM_QUALITY_H_
