#include "kg_compiler/control_plane/seam_cache.h"

#include "kg_base/common/stopwatch.h"

namespace kg_compiler {
namespace {

constexpr int kMaxIdle = 3;  // Graphs; constraints and waypoints may
                             // disappear and return.

KeptSeams::Place PlaceOf(kg_base::LonLat position) {
  return {position.lon_deg, position.lat_deg};
}

bool Holds(const SurfacePatch& patch, const WindowSurface& surface,
           const KeptSeams::Arrivals& arrivals) {
  return patch.SameOpen(surface, arrivals.hazard) &&
         patch.SameAttenuation(surface, arrivals.read);
}

// Adds its lifetime [s] to a sum.
class ElapsedTimer {
 public:
  explicit ElapsedTimer(double* sum_s) : sum_s_(sum_s) {}
  ~ElapsedTimer() { *sum_s_ += watch_.Elapsed_s(); }
  ElapsedTimer(const ElapsedTimer&) = delete;
  ElapsedTimer& operator=(const ElapsedTimer&) = delete;

 private:
  double* sum_s_;
  kg_base::Stopwatch watch_;
};

template <typename Map>
void LetGoOfIdle(Map* kept) {
  for (auto at = kept->begin(); at != kept->end();) {
    at = at->second.idle >= kMaxIdle ? kept->erase(at) : std::next(at);
  }
}

template <typename Map>
void Age(Map* kept) {
  for (auto& [place, one] : *kept) ++one.idle;
}

}  // namespace

SeamFlyer::SeamFlyer(const WindowTraversal& traversal,
                     const std::string& tensor_hash, const KeptSeams* last,
                     SeamCounts* counts)
    : traversal_(traversal),
      counts_(counts),
      now_(std::make_shared<KeptSeams>()) {
  now_->terms = traversal.Terms();
  now_->tensor_hash = tensor_hash;
  if (last == nullptr) return;
  if (last->terms == now_->terms) {
    now_->picks = last->picks;
    TakeOver(*last, last->tensor_hash == tensor_hash);
  }
}

void SeamFlyer::TakeOver(const KeptSeams& last, bool same_tensor) {
  for (const auto& [place, source] : last.sources) {
    if (!same_tensor &&
        !Holds(last.patch, traversal_.surface(), *source.arrivals)) {
      continue;
    }
    KeptSeams::Source& kept =
        now_->sources.emplace_hint(now_->sources.end(), place, source)->second;
    Age(&kept.flights);
  }
  Age(&now_->sources);
}

std::shared_ptr<const KeptSeams::Arrivals> SeamFlyer::Arrive(
    kg_base::LonLat source) const {
  auto arrivals = std::make_shared<KeptSeams::Arrivals>();
  arrivals->reach = traversal_.ReachFrom(source);
  const kg_base::Grid& grid = traversal_.grid();
  // Landings: cells reached no earlier than the time from which station can be
  // held.
  for (const ReachedCell& cell : arrivals->reach.cells) {
    const kg_base::LonLat centre =
        grid.Centre({cell.index / grid.cols(), cell.index % grid.cols()});
    if (traversal_.begin_s() + cell.arrival_s >=
        traversal_.HoldableFrom_s(centre)) {
      arrivals->landings.push_back(cell.index);
    }
  }
  // The box read includes at least the source's own cell, even if no cell is
  // reached.
  arrivals->read = arrivals->reach.read;
  if (const std::optional<kg_base::Cell> cell = grid.CellAt(source)) {
    arrivals->read = Join(arrivals->read,
                          {cell->row, cell->row + 1, cell->col, cell->col + 1});
  }
  arrivals->hazard = traversal_.HazardBox(arrivals->read);
  return arrivals;
}

KeptSeams::Source& SeamFlyer::SourceAt(kg_base::LonLat place) {
  KeptSeams::Source& source = now_->sources[PlaceOf(place)];
  if (source.arrivals == nullptr) {
    const ElapsedTimer spent(&counts_->seams_s);
    source.arrivals = Arrive(place);
    ++counts_->reaches;
  } else if (source.idle > 0) {
    ++counts_->reaches_kept;
  }
  source.idle = 0;
  return source;
}

const std::vector<int>& SeamFlyer::Landings(kg_base::LonLat source) {
  return SourceAt(source).arrivals->landings;
}

std::shared_ptr<const FlownPath> SeamFlyer::Fly(kg_base::LonLat source,
                                                kg_base::LonLat to) {
  KeptSeams::Source& from = SourceAt(source);
  const auto [flown, is_new] = from.flights.try_emplace(PlaceOf(to));
  if (is_new) {
    const ElapsedTimer spent(&counts_->seams_s);
    std::optional<FlownPath> flight =
        traversal_.Fly(source, from.arrivals->reach, to);
    if (flight) {
      flown->second.flight =
          std::make_shared<const FlownPath>(std::move(*flight));
    }
    ++counts_->flights;
  } else if (flown->second.idle > 0) {
    ++counts_->flights_kept;
  }
  flown->second.idle = 0;
  return flown->second.flight;
}

std::shared_ptr<const KeptSeams> SeamFlyer::Keep() {
  LetGoOfIdle(&now_->sources);
  CellBox all;
  for (auto& [place, source] : now_->sources) {
    LetGoOfIdle(&source.flights);
    all = Join(all, source.arrivals->hazard);
  }
  now_->patch = SurfacePatch(traversal_.surface(), all);
  return std::move(now_);
}

}  // namespace kg_compiler
