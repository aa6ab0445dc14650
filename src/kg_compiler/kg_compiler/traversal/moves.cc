#include "kg_compiler/traversal/moves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

// Points along a segment at which all its corner crossings fall, for steps of
// up to three cells.
constexpr int kPoints = 840;
constexpr double kTouch = 0.5 + 1e-6;

bool Touches(int rows, int cols, kg_core::Cell cell) {
  for (int k = 0; k <= kPoints; ++k) {
    const double share = static_cast<double>(k) / kPoints;
    if (std::abs(share * rows - cell.row) <= kTouch &&
        std::abs(share * cols - cell.col) <= kTouch) {
      return true;
    }
  }
  return false;
}

Move MakeMove(int rows, int cols) {
  Move move{rows, cols, {}, {}};
  for (int r = std::min(rows, 0); r <= std::max(rows, 0); ++r) {
    for (int c = std::min(cols, 0); c <= std::max(cols, 0); ++c) {
      if ((r != 0 || c != 0) && Touches(rows, cols, {r, c})) {
        move.touched.push_back({r, c});
      }
    }
  }
  const int parts = static_cast<int>(std::ceil(std::hypot(rows, cols)));
  for (int k = 0; k < parts; ++k) {
    const double row = rows * (k + 0.5) / parts;
    const double col = cols * (k + 0.5) / parts;
    const int r = static_cast<int>(std::floor(row));
    const int c = static_cast<int>(std::floor(col));
    move.samples.push_back({{r, c}, row - r, col - c});
  }
  return move;
}

double OrCalm(float x) { return std::isnan(x) ? 0.0 : x; }

}  // namespace

std::vector<Move> NeighbourMoves(int neighbours) {
  if (neighbours != 16 && neighbours != 32) {
    throw std::logic_error("a search has 16 or 32 neighbours");
  }
  const int longest = neighbours == 16 ? 2 : 3;
  std::vector<Move> moves;
  for (int dr = -longest; dr <= longest; ++dr) {
    for (int dc = -longest; dc <= longest; ++dc) {
      const int a = std::abs(dr), b = std::abs(dc);
      const bool unit = a + b == 1 || (a == 1 && b >= 1) || (b == 1 && a >= 1);
      if (unit || a * b == 6) {
        moves.push_back(MakeMove(dr, dc));
      }
    }
  }
  return moves;
}

Mover::Mover(const Voyage& voyage)
    : field_(*voyage.world.field),
      open_(*voyage.world.open),
      speed_mps_(voyage.motion.cruise_mps),
      boost_gain_(voyage.motion.boost_gain),
      latest_s_(LatestArrival_s(voyage.motion, voyage.departure)) {
  for (const kg_core::FieldSlice& slice : field_.slices) {
    slice_s_.push_back(slice.time_s - voyage.departure.time_s);
  }
  for (const double lat_deg : field_.grid.lat_deg()) {
    scale_.push_back(kg_core::LocalScale(lat_deg));
  }
}

bool Mover::MayEnter(kg_core::Cell cell) const {
  if (!field_.grid.Contains(cell)) return false;
  const std::size_t i = field_.grid.Index(cell);
  return open_[i] == 1 && !std::isnan(field_.slices.front().east_mps[i]);
}

Mover::Course Mover::CourseOf(const Move& move, kg_core::Cell from) const {
  const kg_core::Grid& grid = field_.grid;
  const int row = from.row + move.rows;
  const double lon_deg =
      grid.lon_deg()[from.col + move.cols] - grid.lon_deg()[from.col];
  const double lat_deg = grid.lat_deg()[row] - grid.lat_deg()[from.row];
  const kg_core::DegreesPerMetre& a = scale_[from.row];
  const kg_core::DegreesPerMetre& b = scale_[row];
  const double east_m = lon_deg * 2.0 / (a.lon_deg + b.lon_deg);
  const double north_m = lat_deg * 2.0 / (a.lat_deg + b.lat_deg);
  const double length_m = std::sqrt(east_m * east_m + north_m * north_m);
  return {length_m, east_m / length_m, north_m / length_m};
}

kg_core::Velocity Mover::Current(const Move::Sample& sample, kg_core::Cell from,
                                 double time_s) const {
  std::size_t k = 0;
  while (k + 2 < slice_s_.size() && slice_s_[k + 1] <= time_s) ++k;
  const std::size_t l = std::min(k + 1, slice_s_.size() - 1);
  const double span_s = slice_s_[l] - slice_s_[k];
  const double late =
      span_s > 0.0 ? std::clamp((time_s - slice_s_[k]) / span_s, 0.0, 1.0)
                   : 0.0;
  const std::size_t cols = static_cast<std::size_t>(field_.grid.cols());
  const std::size_t sw = field_.grid.Index(
      {from.row + sample.corner.row, from.col + sample.corner.col});
  const std::size_t east = sample.east > 0.0 ? 1 : 0;
  const std::size_t north = sample.north > 0.0 ? cols : 0;
  const auto mean = [&](const kg_core::Raster& values) {
    const double s = OrCalm(values[sw]) * (1.0 - sample.east) +
                     OrCalm(values[sw + east]) * sample.east;
    const double n = OrCalm(values[sw + north]) * (1.0 - sample.east) +
                     OrCalm(values[sw + north + east]) * sample.east;
    return s * (1.0 - sample.north) + n * sample.north;
  };
  const kg_core::FieldSlice& a = field_.slices[k];
  const kg_core::FieldSlice& b = field_.slices[l];
  const double early = boost_gain_ * (1.0 - late);
  kg_core::Velocity c{early * mean(a.east_mps), early * mean(a.north_mps)};
  if (late > 0.0) {
    c.east_mps += boost_gain_ * late * mean(b.east_mps);
    c.north_mps += boost_gain_ * late * mean(b.north_mps);
  }
  return c;
}

std::optional<double> Mover::Arrival(const Move& move, kg_core::Cell from,
                                     double depart_s) const {
  for (const kg_core::Cell& offset : move.touched) {
    if (!MayEnter({from.row + offset.row, from.col + offset.col})) {
      return std::nullopt;
    }
  }
  const Course course = CourseOf(move, from);
  const double part_m =
      course.length_m / static_cast<double>(move.samples.size());
  double time_s = depart_s;
  double half_s = 0.0;  // To the middle of the next part, by the last rate.
  for (const Move::Sample& sample : move.samples) {
    const kg_core::Velocity c = Current(sample, from, time_s + half_s);
    const double along = c.east_mps * course.east + c.north_mps * course.north;
    const double across = c.east_mps * course.north - c.north_mps * course.east;
    if (!(std::abs(across) <= (1.0 - kSearch.slack) * speed_mps_)) {
      return std::nullopt;
    }
    const double ground_mps =
        along + std::sqrt(speed_mps_ * speed_mps_ - across * across);
    if (!(ground_mps >= kSearch.slack * speed_mps_)) return std::nullopt;
    time_s += part_m / ground_mps;
    half_s = 0.5 * part_m / ground_mps;
    if (!(time_s <= latest_s_)) return std::nullopt;
  }
  return time_s;
}

}  // namespace kg_compiler
