#include "kg_compiler/traversal/shooting.h"

#include <algorithm>
#include <cmath>

#include "kg_compiler/traversal/leg.h"
#include "kg_compiler/traversal/sight.h"
#include "kg_compiler/traversal/sweep.h"

namespace kg_compiler {
namespace {

constexpr double kHit_cells = 0.01;  // Accepted miss distance.
constexpr double kBent_cells = 0.5;  // Largest correction spread over a course.
constexpr int kMaxTimings = 10;      // Newton iterations for the time.
constexpr double kTimed_cells = 1e-4;
// Largest shift of the front per iteration.
constexpr double kMaxShift_cells = 1.5;
// A shot that misses by more is discarded.
constexpr double kFarthest_cells = 8.0;
constexpr int kWidenings = 4;  // Widenings of the spread, by a factor of 3.
constexpr double kLeastSpread_rad = 1e-6;
constexpr int kMaxHalvings = 30;
constexpr double kSolveStep_cells = 0.5;
constexpr int kFewestSteps = 6;
// A leg of more steps is not tried: its current carries it farther in a second
// than a grid is wide.
constexpr int kMaxSteps = 100000;

// Equal steps of at most `step_s`; nullopt = more than kMaxSteps, or NaN.
std::optional<int> CountSteps(double duration_s, double step_s) {
  const double steps = std::ceil(duration_s / step_s);
  if (!(steps >= 1.0 && steps <= kMaxSteps)) return std::nullopt;
  return static_cast<int>(steps);
}

// The point farthest from the chord in time between two kept points.
struct FarthestPoint {
  std::size_t index = 0;
  double cells = 0.0;
};
FarthestPoint FarthestBetween(const TimedCourse& course, std::size_t a,
                              std::size_t b) {
  FarthestPoint farthest;
  const CoursePoint &p = course[a], &q = course[b];
  for (std::size_t i = a + 1; i < b; ++i) {
    const double span_s = q.time_s - p.time_s;
    const double share =
        span_s > 0.0 ? (course[i].time_s - p.time_s) / span_s : 0.0;
    const double row =
        p.place.row + share * (q.place.row - p.place.row) - course[i].place.row;
    const double col =
        p.place.col + share * (q.place.col - p.place.col) - course[i].place.col;
    const double cells = std::sqrt(row * row + col * col);
    if (cells > farthest.cells) farthest = {i, cells};
  }
  return farthest;
}

}  // namespace

TimedCourse Simplify(const TimedCourse& course, double tolerance_cells) {
  if (course.size() < 3) return course;
  // Douglas-Peucker algorithm in time: keep the point farthest from its linear
  // interpolation, then split there and process both halves.
  std::vector<bool> kept(course.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {
      {0, course.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const FarthestPoint farthest = FarthestBetween(course, a, b);
    if (!(farthest.cells > tolerance_cells)) continue;
    kept[farthest.index] = true;
    open.emplace_back(a, farthest.index);
    open.emplace_back(farthest.index, b);
  }
  TimedCourse simple;
  for (std::size_t i = 0; i < course.size(); ++i) {
    if (kept[i]) simple.push_back(course[i]);
  }
  return simple;
}

ExtremalShooter::ExtremalShooter(const VoyageRequest& voyage,
                                 const ReachMap& reach, double speed_mps)
    : reach_(reach),
      flow_(voyage),
      helm_(flow_, speed_mps),
      latest_s_(LatestArrival_s(voyage.motion, voyage.departure)) {}

bool ExtremalShooter::Advance(double time_s, double step_s,
                              ExtremalState* at) const {
  *at = helm_.Advance(*at, ExtremalStepper::Step(flow_, time_s, step_s));
  // A front that runs along its normal may be moved any distance by a small
  // correction of its time; NaN fails these comparisons, too.
  const kg_base::Grid& grid = flow_.grid();
  return at->row > -kFarthest_cells && at->col > -kFarthest_cells &&
         at->row < grid.rows() + kFarthest_cells &&
         at->col < grid.cols() + kFarthest_cells &&
         IsWithin(flow_.felt(), reach_.read);
}

// Integrates to the guessed time, then forward or back until the front is at
// the target.
std::optional<ShotAt> ExtremalShooter::Fire(const ShotLeg& leg,
                                            double heading_rad) const {
  flow_.Forget();
  ExtremalState at = SetOut(flow_, leg.from, heading_rad);
  const std::optional<int> steps = CountSteps(leg.duration_s, leg.step_s);
  if (!steps) return std::nullopt;
  const double step_s = leg.duration_s / *steps;
  double time_s = leg.begin_s;
  for (int i = 0; i < *steps; ++i, time_s += step_s) {
    if (!Advance(time_s, step_s, &at)) return std::nullopt;
  }
  // Newton's method in time: `ahead` is how far the front is past the target,
  // `front` its speed along its normal.
  const CellOffset target{leg.to.col, leg.to.row};
  for (int i = 0; i < kMaxTimings; ++i) {
    const CellOffset normal = NormalOf(flow_, at);
    const CellOffset miss = PlaceOf(at) - target;
    const double ahead = normal.dot(miss) / normal.norm();
    const double left = Cross(normal, miss) / normal.norm();
    if (!(miss.norm() < kFarthest_cells)) return std::nullopt;
    if (std::abs(ahead) < kTimed_cells) {
      return ShotAt{heading_rad, time_s - leg.begin_s, left};
    }
    const kg_base::GridPoint v = helm_.Velocity(at, flow_.At(time_s));
    const double front = normal.dot(CellOffset{v.col, v.row}) / normal.norm();
    const double most_s = kMaxShift_cells / std::max(std::abs(front), 1e-12);
    const double shift_s = std::min(std::max(-ahead / front, -most_s), most_s);
    if (!(time_s + shift_s > leg.begin_s)) return std::nullopt;
    if (!Advance(time_s, shift_s, &at)) return std::nullopt;
    time_s += shift_s;
  }
  return std::nullopt;
}

namespace {

void KeepBetter(const std::optional<ShotAt>& shot,
                std::optional<ShotAt>* best) {
  if (shot && (!*best || std::abs(shot->left) < std::abs((*best)->left))) {
    *best = shot;
  }
}

bool OnBothSides(const std::optional<ShotAt>& a,
                 const std::optional<ShotAt>& b) {
  return a && b && (a->left > 0.0) != (b->left > 0.0);
}

}  // namespace

// Illinois method: regula falsi that halves the weight of an end kept twice.
// Returns the best shot even if none hits, which happens where extremals
// repeatedly cross a line of centres along which the current is strongest.
std::optional<ShotAt> ExtremalShooter::Between(const ShotLeg& leg, ShotAt a,
                                               ShotAt b) const {
  double weight_a = a.left, weight_b = b.left;
  int kept = 0;
  std::optional<ShotAt> best = a;
  KeepBetter(b, &best);
  for (int i = 0; i < kMaxHalvings && std::abs(best->left) > kHit_cells; ++i) {
    // Every fourth step bisects: regula falsi alone converges slowly where m is
    // steep on one side.
    const bool halve = i % 4 == 3;
    const double share = halve ? 0.5 : weight_a / (weight_a - weight_b);
    const auto shot =
        Fire(leg, a.heading_rad + share * (b.heading_rad - a.heading_rad));
    if (!shot) break;
    KeepBetter(shot, &best);
    if ((shot->left > 0.0) == (a.left > 0.0)) {
      a = *shot;
      weight_a = a.left;
      weight_b = kept == 1 ? 0.5 * weight_b : b.left;
      kept = 1;
    } else {
      b = *shot;
      weight_b = b.left;
      weight_a = kept == -1 ? 0.5 * weight_a : a.left;
      kept = -1;
    }
  }
  return best;
}

std::optional<ShotAt> ExtremalShooter::Search(const ShotLeg& leg) const {
  std::optional<ShotAt> low = Fire(leg, leg.heading_rad), high = low;
  std::optional<ShotAt> best = low;
  if (best && std::abs(best->left) < kHit_cells) return best;
  // As long as extremals have not crossed, a shot that passes left of the
  // target started too far to the left: search to the right first.
  double turn_rad = std::max(leg.spread_rad, kLeastSpread_rad);
  if (low && low->left > 0.0) turn_rad = -turn_rad;
  for (int i = 0; i < kWidenings; ++i, turn_rad *= 3.0) {
    const auto nearer = Fire(leg, leg.heading_rad + turn_rad);
    if (OnBothSides(low, nearer)) return Between(leg, *low, *nearer);
    const auto farther = Fire(leg, leg.heading_rad - turn_rad);
    if (OnBothSides(high, farther)) return Between(leg, *high, *farther);
    KeepBetter(nearer, &best);
    KeepBetter(farther, &best);
    low = nearer;
    high = farther;
    if (!low && !high) break;
  }
  return best;
}

std::optional<ShotAt> ExtremalShooter::Solve(const ShotLeg& leg) const {
  if (!(leg.duration_s > 0.0)) return std::nullopt;
  const std::optional<ShotAt> best = Search(leg);
  if (!best || !(std::abs(best->left) < kBent_cells)) return std::nullopt;
  return best;
}

bool ExtremalShooter::Trace(const ShotLeg& leg, const ShotAt& shot,
                            TimedCourse* course) const {
  flow_.Forget();
  ExtremalState at = SetOut(flow_, leg.from, shot.heading_rad);
  const std::optional<int> steps = CountSteps(shot.duration_s, leg.step_s);
  if (!steps) return false;
  const double step_s = shot.duration_s / *steps;
  const std::size_t first = course->size();
  for (int i = 0; i < *steps; ++i) {
    const double time_s = leg.begin_s + i * step_s;
    course->push_back({{at.row, at.col}, time_s});
    if (!Advance(time_s, step_s, &at)) return false;
  }
  // Distribute the remaining miss linearly along the course.
  const CellOffset miss = PlaceOf(at) - CellOffset{leg.to.col, leg.to.row};
  if (!(miss.norm() < 2.0 * kBent_cells)) return false;
  for (int i = 0; i < *steps; ++i) {
    kg_base::GridPoint& place = (*course)[first + i].place;
    place.col -= miss.x() * i / *steps;
    place.row -= miss.y() * i / *steps;
  }
  return true;
}

std::optional<TimedCourse> ExtremalShooter::To(kg_base::GridPoint place,
                                               const Guess& guess,
                                               double step_cells) const {
  std::vector<int> roots;  // From the last root back to the departure.
  for (int root = guess.root; root >= 0; root = reach_.roots[root].parent) {
    roots.push_back(root);
  }
  TimedCourse course;
  double begin_s = 0.0;
  // From the departure through the corners: each leg starts where and when the
  // previous one arrived.
  for (std::size_t i = roots.size(); i-- > 0;) {
    const ReachRoot& root = reach_.roots[roots[i]];
    ShotLeg leg{root.place,
                place,
                begin_s,
                guess.heading_rad,
                guess.spread_rad,
                guess.arrival_s - root.time_s,
                0.0};
    if (i > 0) {
      const ReachRoot& next = reach_.roots[roots[i - 1]];
      leg.to = next.place;
      leg.heading_rad = next.heading_rad;
      leg.spread_rad = next.spread_rad;
      leg.duration_s = next.time_s - root.time_s;
    }
    // Coarse steps to solve for the heading, then finer ones for the course.
    leg.step_s = std::min(kSolveStep_cells / reach_.cells_per_s,
                          leg.duration_s / kFewestSteps);
    const auto shot = Solve(leg);
    if (!shot) return std::nullopt;
    leg.step_s = std::min(leg.step_s, step_cells / reach_.cells_per_s);
    if (!Trace(leg, *shot, &course)) return std::nullopt;
    begin_s += shot->duration_s;
    if (!(begin_s <= latest_s_)) return std::nullopt;
  }
  course.push_back({place, begin_s});
  return course;
}

}  // namespace kg_compiler
