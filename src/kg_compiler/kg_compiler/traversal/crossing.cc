#include "kg_compiler/traversal/crossing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kg_compiler/traversal/flight.h"
#include "kg_compiler/traversal/sight.h"

namespace kg_compiler {
namespace {

constexpr int kSeedRadius_cells = 2;
constexpr int kMaxSeeds = 6;
constexpr double kStep_cells = 0.5;
constexpr double kFineStep_cells = 0.08;
constexpr double kTolerance_cells = 0.05;
// Relative delay against the fan's arrival up to which a flight is accepted.
constexpr double kExpected = 0.005;
constexpr double kNearCells = 1.0;
constexpr double kSame = 1e-3;  // Relative difference of equal travel times.
// Fractions of the speed held in reserve when computing a course, so that the
// flight along its legs can correct: where the current is stronger than the
// agent, a course at the edge of the reachable cone leaves no margin.
constexpr double kReserves[] = {0.0, 0.005, 0.02, 0.05};

// The inner box whose flights read nothing outside of `box`: interpolation
// reaches one cell further.
CellBox Inside(const CellBox& box, const kg_base::Grid& grid) {
  return {box.row > 0 ? box.row + 1 : 0,
          box.row_end < grid.rows() ? box.row_end - 1 : box.row_end,
          box.col > 0 ? box.col + 1 : 0,
          box.col_end < grid.cols() ? box.col_end - 1 : box.col_end};
}

void KeepFaster(std::optional<FlownPath> flight,
                std::optional<FlownPath>* best) {
  if (!flight || (*best && (*best)->travel_s <= flight->travel_s)) return;
  *best = std::move(flight);
}

}  // namespace

FastestCrossing::FastestCrossing(const VoyageRequest& voyage,
                                 const ReachMap& reach, kg_base::LonLat to,
                                 kg_base::GridPoint at)
    : voyage_(voyage),
      reach_(reach),
      grid_(voyage.world.field->grid),
      inside_(Inside(reach.read, grid_)),
      to_(to),
      at_(at) {}

std::optional<FlownPath> FastestCrossing::Best(bool as_expected) const {
  if (!Holds(inside_, CellOf(grid_, at_))) return std::nullopt;
  std::optional<FlownPath> best = Fly({voyage_.departure.from, to_});
  const std::vector<ExtremalShooter::Guess> guesses = Guesses();
  if (guesses.empty()) return best;
  // A larger reserve leaves more margin for correction but arrives later: take
  // the first reserve whose course can be flown.
  for (const double reserve : kReserves) {
    const ExtremalShooter shooter(voyage_, reach_,
                                  (1.0 - reserve) * voyage_.motion.cruise_mps);
    std::vector<double> refused_s;
    for (const ExtremalShooter::Guess& guess : guesses) {
      KeepFaster(Shoot(shooter, guess, &refused_s), &best);
      if (!best) continue;
      if (!as_expected || IsExpected(best->travel_s, guesses.front())) {
        return best;
      }
    }
    if (refused_s.empty()) break;  // No course: none with less speed.
  }
  // Straight legs round the corners may work where no extremal could be flown.
  for (const ExtremalShooter::Guess& guess : guesses) {
    if (guess.root > 0) KeepFaster(Fly(Corners(guess.root)), &best);
  }
  return best;
}

// True if the arrival agrees with the fan's within 0.5 % plus the time for one
// cell (the guess is for a cell centre, not for the place itself).
bool FastestCrossing::IsExpected(double travel_s,
                                 const ExtremalShooter::Guess& guess) const {
  const double near_s = kNearCells / reach_.cells_per_s;
  return travel_s <= (1.0 + kExpected) * guess.arrival_s + near_s;
}

// Waypoints from the departure through the corners to the target.
std::vector<kg_base::LonLat> FastestCrossing::Corners(int root) const {
  std::vector<kg_base::LonLat> via(1, to_);
  for (; root > 0; root = reach_.roots[root].parent) {
    via.push_back(grid_.Position(reach_.roots[root].place));
  }
  via.push_back(voyage_.departure.from);
  std::reverse(via.begin(), via.end());
  return via;
}

std::optional<FlownPath> FastestCrossing::Fly(
    const std::vector<kg_base::LonLat>& via) const {
  return FlyTrack(voyage_, via, &inside_);
}

std::optional<FlownPath> FastestCrossing::Fly(const TimedCourse& course) const {
  std::vector<kg_base::LonLat> via(1, voyage_.departure.from);
  for (std::size_t i = 1; i + 1 < course.size(); ++i) {
    const kg_base::LonLat at = grid_.Position(course[i].place);
    if (at != via.back()) via.push_back(at);
  }
  if (to_ != via.back()) via.push_back(to_);
  return Fly(via);
}

// Extremals through the cells around the target, nearest cell centre first.
std::vector<ExtremalShooter::Guess> FastestCrossing::Guesses() const {
  const kg_base::Cell target = CellOf(grid_, at_);
  struct Seed {
    double rank_s;
    const ReachedCell* cell;
  };
  std::vector<Seed> seeds;
  for (int dr = -kSeedRadius_cells; dr <= kSeedRadius_cells; ++dr) {
    for (int dc = -kSeedRadius_cells; dc <= kSeedRadius_cells; ++dc) {
      const kg_base::Cell cell{target.row + dr, target.col + dc};
      if (!grid_.Contains(cell)) continue;
      const ReachedCell* found =
          reach_.Find(static_cast<int>(grid_.Index(cell)));
      if (!found) continue;
      const double away = std::hypot(cell.row - at_.row, cell.col - at_.col);
      seeds.push_back({away, found});
    }
  }
  // Sort by distance; ties keep the row-major order.
  std::stable_sort(
      seeds.begin(), seeds.end(),
      [](const Seed& a, const Seed& b) { return a.rank_s < b.rank_s; });
  std::vector<ExtremalShooter::Guess> guesses;
  for (const Seed& seed : seeds) {
    if (guesses.size() == kMaxSeeds) break;
    guesses.push_back({seed.cell->root, seed.cell->heading_rad,
                       seed.cell->spread_rad, seed.cell->arrival_s});
  }
  return guesses;
}

// Flies the course of one guess; skipped if its time matches a course that was
// already rejected.
std::optional<FlownPath> FastestCrossing::Shoot(
    const ExtremalShooter& shooter, const ExtremalShooter::Guess& guess,
    std::vector<double>* refused_s) const {
  const auto course = shooter.To(at_, guess, kStep_cells);
  if (!course) return std::nullopt;
  const double time_s = course->back().time_s;
  for (const double known_s : *refused_s) {
    if (std::abs(time_s - known_s) < kSame * time_s) return std::nullopt;
  }
  refused_s->push_back(time_s);
  if (auto flight = Fly(Simplify(*course, kTolerance_cells))) return flight;
  if (auto flight = Fly(*course)) return flight;
  const auto fine = shooter.To(at_, guess, kFineStep_cells);
  return fine ? Fly(*fine) : std::nullopt;
}

}  // namespace kg_compiler
