#include "kg_compiler/traversal/traversal.h"

#include <algorithm>
#include <cmath>

#include "kg_compiler/traversal/leg.h"

namespace kg_compiler {
namespace {

constexpr int kTargetRadius_cells = 2;
constexpr double kLeaveOutLoss = 2e-4;  // Of the time so far.
constexpr int kMostPasses = 4;

using Track = std::vector<kg_core::LonLat>;

// The cell of the search from which the target is reached first.
const ReachedCell* LastCell(const LegFlyer& flyer, const Reach& reach,
                            kg_core::LonLat to) {
  const kg_core::Grid& grid = flyer.grid();
  const std::optional<kg_core::GridPoint> at = grid.Locate(to);
  if (!at) return nullptr;
  const kg_core::Cell target = flyer.CellOf(*at);
  const ReachedCell* best = nullptr;
  double earliest_s = std::numeric_limits<double>::infinity();
  for (int dr = -kTargetRadius_cells; dr <= kTargetRadius_cells; ++dr) {
    for (int dc = -kTargetRadius_cells; dc <= kTargetRadius_cells; ++dc) {
      const kg_core::Cell cell{target.row + dr, target.col + dc};
      if (!grid.Contains(cell)) continue;
      const ReachedCell* last = reach.Find(static_cast<int>(grid.Index(cell)));
      if (!last || !(last->arrival_s < earliest_s)) continue;
      const std::optional<LegEnd> end =
          flyer.Fly({grid.Centre(cell), to, last->arrival_s}, kSearch);
      if (!end || !(end->arrive_s < earliest_s)) continue;
      earliest_s = end->arrive_s;
      best = last;
    }
  }
  return best;
}

Track CellTrack(const kg_core::Grid& grid, const Reach& reach,
                const ReachedCell* last, kg_core::LonLat from,
                kg_core::LonLat to) {
  Track track(1, to);
  for (const ReachedCell* cell = last; cell != nullptr;
       cell = cell->parent < 0 ? nullptr : reach.Find(cell->parent)) {
    const kg_core::LonLat centre =
        grid.Centre({cell->index / grid.cols(), cell->index % grid.cols()});
    if (centre != track.back()) track.push_back(centre);
  }
  if (track.back() != from) track.push_back(from);
  std::reverse(track.begin(), track.end());
  return track;
}

// One pass over the turning points: leaves out each without which the next is
// reached no later (but for the loss allowed). True if any was left out.
bool LeaveOut(const LegFlyer& flyer, Track* track) {
  Track kept(1, track->front());
  double time_s = 0.0;  // At the last point kept.
  for (std::size_t i = 1; i + 1 < track->size(); ++i) {
    const kg_core::LonLat here = (*track)[i], next = (*track)[i + 1];
    const auto by = flyer.Fly({kept.back(), here, time_s}, kSearch);
    if (!by) return false;
    const auto bent = flyer.Fly({here, next, by->arrive_s}, kSearch);
    const auto straight = flyer.Fly({kept.back(), next, time_s}, kSearch);
    const bool keep =
        !straight || (bent && !(straight->arrive_s <=
                                bent->arrive_s * (1.0 + kLeaveOutLoss)));
    if (!keep) continue;
    kept.push_back(here);
    time_s = by->arrive_s;
  }
  kept.push_back(track->back());
  const bool changed = kept.size() < track->size();
  *track = std::move(kept);
  return changed;
}

std::optional<Flight> Faster(std::optional<Flight> a, std::optional<Flight> b) {
  if (!a) return b;
  if (!b) return a;
  return b->travel_s < a->travel_s ? b : a;
}

}  // namespace

std::optional<Flight> Traverse(const Voyage& voyage, const Reach& reach,
                               kg_core::LonLat to) {
  const Departure& departure = voyage.departure;
  const Track straight = {departure.from, to};
  std::optional<Flight> best = FlyTrack(voyage, straight);
  const LegFlyer flyer(voyage);
  const ReachedCell* last = LastCell(flyer, reach, to);
  if (!last || departure.from == to) return best;
  const Track cells = CellTrack(flyer.grid(), reach, last, departure.from, to);
  Track pulled = cells;
  for (int i = 0; i < kMostPasses && LeaveOut(flyer, &pulled); ++i) {
  }
  if (pulled != straight) {
    std::optional<Flight> bent = FlyTrack(voyage, pulled);
    if (!bent && !best) bent = FlyTrack(voyage, cells);
    best = Faster(std::move(best), std::move(bent));
  }
  return best;
}

}  // namespace kg_compiler
