// Starts of new fans: corners of closed regions, and grazed edges.

#include <algorithm>
#include <cmath>

#include "kg_base/common/units.h"
#include "kg_compiler/traversal/fan.h"

namespace kg_compiler {
namespace {

constexpr int kCornerRays = 10;
constexpr double kCornerBegin_rad = -0.15;  // Across the arriving heading.
constexpr double kCornerEnd_rad = 0.9 * kg_base::kPi;  // Into the shadow.

// Lengths in cells.
constexpr double kBeside = 0.3;  // A corner passed closer than this is reached.
constexpr double kBesideSpread_rad = 0.02;
constexpr double kHeadOn = 0.4;  // Sine of the angle to the sides of a corner.
// A free distance of this length ahead means that the edge has been passed.
constexpr double kGrazeAhead = 1.5;
constexpr double kGrazeAside = 0.8;

}  // namespace

void ExtremalFan::FindCorners(const Stride& stride, const ExtremalStrand& a,
                              const ExtremalStrand& b, const FrontSweep& sweep,
                              kg_base::Cell cell) {
  if (!sight_.IsOpen(cell)) return;
  const unsigned corners = sight_.Corners(cell);
  for (int k = 0; k < 4; ++k) {
    if (!(corners & (1u << k))) continue;
    const kg_base::GridPoint at = LineOfSight::CornerAt(cell, k);
    const auto share = sweep.Find({at.col, at.row});
    if (!share) continue;
    const CellOffset from = sweep.BeginAt(share->across);
    const double spread_rad = b.heading_rad - a.heading_rad;
    AddCorner(stride,
              {sweep.Time_s(*share), at, stride.root,
               a.heading_rad + share->across * spread_rad, std::abs(spread_rad),
               0.0, 0, 4 * static_cast<int>(grid_.Index(cell)) + k},
              from, share->across < 0.5 ? a : b);
  }
}

// Finds corners passed closely by an extremal at the end of a chain, which no
// strip between neighbours would cover.
void ExtremalFan::FindCornersBeside(const Stride& stride,
                                    const ExtremalStrand& strand) {
  const CellOffset from = PlaceOf(strand.begin);
  const CellOffset go = PlaceOf(strand.end) - from;
  const kg_base::Cell a = CellOf(grid_, {strand.begin.row, strand.begin.col});
  const kg_base::Cell b = CellOf(grid_, {strand.end.row, strand.end.col});
  if (strand.dead || !(go.norm() > 0.0) ||
      (!sight_.NearClosed(a) && !sight_.NearClosed(b))) {
    return;
  }
  // A corner is passed if its projection falls on the segment and its distance
  // to it is below kBeside.
  for (int row = std::min(a.row, b.row) - 1; row <= std::max(a.row, b.row) + 1;
       ++row) {
    for (int col = std::min(a.col, b.col) - 1;
         col <= std::max(a.col, b.col) + 1; ++col) {
      if (!sight_.IsOpen({row, col})) continue;
      const unsigned corners = sight_.Corners({row, col});
      for (int k = 0; k < 4; ++k) {
        if (!(corners & (1u << k))) continue;
        const kg_base::GridPoint at = LineOfSight::CornerAt({row, col}, k);
        const CellOffset away = CellOffset{at.col, at.row} - from;
        const double share = away.dot(go) / go.dot(go);
        if (!(share >= 0.0 && share <= 1.0) ||
            !((away - share * go).norm() < kBeside)) {
          continue;
        }
        AddCorner(stride,
                  {share * stride.step->length_s, at, stride.root,
                   strand.heading_rad, kBesideSpread_rad, 0.0, 0,
                   4 * static_cast<int>(grid_.Index({row, col})) + k},
                  from, strand);
      }
    }
  }
}

// Completes `found` (arrival heading, side, absolute time) and queues it.
// On entry found.time_s counts from the begin of the step.
void ExtremalFan::AddCorner(const Stride& stride, Restart found,
                            const CellOffset& from,
                            const ExtremalStrand& near) {
  // Clamp to the step: the cubic front may extrapolate beyond it.
  found.time_s = stride.begin_s +
                 std::clamp(found.time_s, 0.0, 0.999 * stride.step->length_s);
  if (rounded_.count(found.key) || !(found.time_s < latest_s_) ||
      !sight_.IsClear({from.y(), from.x()}, found.place)) {
    return;
  }
  // Accept only rays that pass beside the corner, not rays that head towards it
  // or away from it.
  const CellOffset go = PlaceOf(near.end) - PlaceOf(near.begin);
  const kg_base::Cell d =
      LineOfSight::kDiagonals[static_cast<std::size_t>(found.key % 4)];
  const double slack = kHeadOn * go.norm();
  const double east = d.col * go.x(), north = d.row * go.y();
  if ((east > slack && north > slack) || (east < -slack && north < -slack)) {
    return;
  }
  const CellOffset corner{static_cast<double>(d.col),
                          static_cast<double>(d.row)};
  found.side = Cross(go, corner) > 0.0 ? 1 : -1;
  found.arriving_rad = HeadingOf(flow_, near.end);
  restarts_.push_back(found);
}

// Handles the last live ray beside closed cells, whose neighbour was stopped by
// them: unless it is about to be stopped itself, the region behind the closed
// cells is in its shadow and needs a new fan.
void ExtremalFan::FindGraze(const Stride& stride, const ExtremalStrand& alive,
                            const ExtremalStrand& dead) {
  const CellOffset end = PlaceOf(alive.end);
  if (!sight_.Contains({dead.end.row, dead.end.col})) return;
  const CellOffset go = end - PlaceOf(alive.begin);
  const double length = go.norm();
  if (!(length > 0.0)) return;
  // It goes on past the closed cells if the way straight ahead is clear.
  const CellOffset ahead = end + (kGrazeAhead / length) * go;
  if (!sight_.Contains({ahead.y(), ahead.x()}) ||
      !sight_.IsClear({end.y(), end.x()}, {ahead.y(), ahead.x()})) {
    return;
  }
  // The shadow lies on the side of the neighbour that was stopped.
  const int side = Cross(go, PlaceOf(dead.end) - end) > 0.0 ? 1 : -1;
  const CellOffset aside =
      end + (side * kGrazeAside / length) * CellOffset{-go.y(), go.x()};
  const kg_base::Cell shadow = CellOf(grid_, {aside.y(), aside.x()});
  if (!sight_.IsOpen(shadow)) return;
  grazes_.push_back({{stride.begin_s + stride.step->length_s,
                      {end.y(), end.x()},
                      stride.root,
                      alive.heading_rad,
                      std::abs(dead.heading_rad - alive.heading_rad),
                      HeadingOf(flow_, alive.end),
                      side,
                      -1},
                     shadow});
}

std::vector<ExtremalFan::Ray> ExtremalFan::ShadowRays(const Restart& restart) {
  const int root = static_cast<int>(reach_.roots.size());
  reach_.roots.push_back({restart.place, restart.time_s, restart.root,
                          restart.heading_rad, restart.spread_rad});
  std::vector<Ray> rays;
  for (int i = 0; i < kCornerRays; ++i) {
    const double turn_rad =
        kCornerBegin_rad +
        (kCornerEnd_rad - kCornerBegin_rad) * i / (kCornerRays - 1);
    const double heading_rad = restart.arriving_rad + restart.side * turn_rad;
    rays.push_back(
        {SetOut(flow_, restart.place, heading_rad), heading_rad, root, true});
  }
  rays.back().linked = false;
  return rays;
}

// Starts the queued fans, earliest first: a corner behind another one may be
// reached within the same step.
void ExtremalFan::Restarts(double end_s) {
  const auto later = [](const Restart& a, const Restart& b) {
    return a.time_s > b.time_s || (a.time_s == b.time_s && a.key > b.key);
  };
  while (!restarts_.empty()) {
    const auto first =
        std::max_element(restarts_.begin(), restarts_.end(), later);
    const Restart restart = *first;
    restarts_.erase(first);
    if (!rounded_.insert(restart.key).second) continue;
    // From the corner to the end of this common step; that may find corners
    // farther on, which join the queue.
    const std::vector<Ray> rays = ShadowRays(restart);
    const ExtremalStepper::Step step(flow_, restart.time_s,
                                     end_s - restart.time_s);
    first_steps_.push_back({step, steps_.size() + 1});
    AdvanceChain({&step, restart.time_s, rays[0].root}, rays, 0);
  }
  // Grazes are found at the end of a step, so their rays begin with the next.
  for (const Graze& graze : grazes_) {
    if (std::isfinite(arrivals_.Arrival_s(graze.shadow))) continue;
    const std::vector<Ray> rays = ShadowRays(graze.restart);
    first_steps_.push_back(
        {ExtremalStepper::Step(flow_, end_s, 0.0), steps_.size() + 1});
    next_.insert(next_.end(), rays.begin(), rays.end());
  }
}

}  // namespace kg_compiler
