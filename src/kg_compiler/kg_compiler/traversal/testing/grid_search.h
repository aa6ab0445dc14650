// Dijkstra's search over cell centres, with moves to 16 or 32 neighbours timed
// at their departure. For tests and benchmarks: the baseline for the fan of
// extremals. Where the current is stronger than the agent, it reports places
// that cannot be flown to and misses places that can.

#ifndef KG_COMPILER_TRAVERSAL_TESTING_GRID_SEARCH_H_
#define KG_COMPILER_TRAVERSAL_TESTING_GRID_SEARCH_H_

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <queue>
#include <stdexcept>
#include <vector>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/traversal/leg.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

// Step 1 cell; 5 % of V must remain in heading correction and ground speed.
inline constexpr LegCare kSearch = {1.0, 0.05};

struct GridReachedCell {
  int index = 0;           // Grid index of the cell.
  double arrival_s = 0.0;  // At its centre, seconds after departure.
  int parent = -1;         // Index of the previous cell, -1 = departure.
};

struct GridReach {
  std::vector<GridReachedCell> cells;  // Ascending by index.

  const GridReachedCell* Find(int index) const {
    const auto at =
        std::lower_bound(cells.begin(), cells.end(), index,
                         [](const GridReachedCell& cell, int wanted) {
                           return cell.index < wanted;
                         });
    return at != cells.end() && at->index == index ? &*at : nullptr;
  }
  // Track through cell centres, starting with the departure.
  std::vector<kg_base::LonLat> Track(const kg_base::Grid& grid,
                                     kg_base::LonLat from, int index) const {
    std::vector<kg_base::LonLat> track;
    for (const GridReachedCell* cell = Find(index); cell != nullptr;
         cell = cell->parent < 0 ? nullptr : Find(cell->parent)) {
      track.push_back(
          grid.Centre({cell->index / grid.cols(), cell->index % grid.cols()}));
    }
    track.push_back(from);
    std::reverse(track.begin(), track.end());
    return track;
  }
};

// A step to a neighbour, in cells.
struct Move {
  int rows = 0;
  int cols = 0;
  // Offsets of all cells that the segment touches (both cells beside a corner),
  // except the one it starts in.
  std::vector<kg_base::Cell> touched;
  // Sample of the current at the middle of equal parts, each no longer than a
  // cell: south-west centre of four and the bilinear weights.
  struct Sample {
    kg_base::Cell corner;
    double north = 0.0;
    double east = 0.0;
  };
  std::vector<Sample> samples;
};

// Coprime steps up to (2, 1) for 16 neighbours, up to (3, 2) for 32.
std::vector<Move> NeighbourMoves(int neighbours);

class Mover {
 public:
  explicit Mover(const VoyageRequest& voyage);

  // Arrival of a move from `from` [s after the departure's time], as
  // `depart_s`; nothing if it cannot be made (kSearch's slack) in time.
  std::optional<double> Arrival(const Move& move, kg_base::Cell from,
                                double depart_s) const;
  bool MayEnter(kg_base::Cell cell) const;  // On the grid, open, known.

 private:
  struct TimedCourse {
    double length_m, east, north;  // (east, north): unit vector.
  };
  TimedCourse CourseOf(const Move& move, kg_base::Cell from) const;
  // boost_gain current; no data counts as no flow.
  kg_base::Velocity Current(const Move::Sample& sample, kg_base::Cell from,
                            double time_s) const;

  const kg_base::VectorField& field_;
  const kg_base::Mask& open_;
  double speed_mps_;
  double boost_gain_;
  double latest_s_;
  std::vector<double> slice_s_;                  // [s after the departure].
  std::vector<kg_base::DegreesPerMetre> scale_;  // By row.
};

namespace grid_search {

// Points along a segment at which all its corner crossings fall, for steps of
// up to three cells.
inline constexpr int kPoints = 840;
inline constexpr double kTouch = 0.5 + 1e-6;

inline bool Touches(int rows, int cols, kg_base::Cell cell) {
  for (int k = 0; k <= kPoints; ++k) {
    const double share = static_cast<double>(k) / kPoints;
    if (std::abs(share * rows - cell.row) <= kTouch &&
        std::abs(share * cols - cell.col) <= kTouch) {
      return true;
    }
  }
  return false;
}

inline Move MakeMove(int rows, int cols) {
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

inline double OrCalm(float x) { return std::isnan(x) ? 0.0 : x; }

}  // namespace grid_search

inline std::vector<Move> NeighbourMoves(int neighbours) {
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
        moves.push_back(grid_search::MakeMove(dr, dc));
      }
    }
  }
  return moves;
}

inline Mover::Mover(const VoyageRequest& voyage)
    : field_(*voyage.world.field),
      open_(*voyage.world.open),
      speed_mps_(voyage.motion.cruise_mps),
      boost_gain_(voyage.motion.boost_gain),
      latest_s_(LatestArrival_s(voyage.motion, voyage.departure)) {
  for (const kg_base::FieldSlice& slice : field_.slices) {
    slice_s_.push_back(slice.time_s - voyage.departure.time_s);
  }
  for (const double lat_deg : field_.grid.lat_deg()) {
    scale_.push_back(kg_base::LocalScale(lat_deg));
  }
}

inline bool Mover::MayEnter(kg_base::Cell cell) const {
  if (!field_.grid.Contains(cell)) return false;
  const std::size_t i = field_.grid.Index(cell);
  return open_[i] == 1 && !std::isnan(field_.slices.front().east_mps[i]);
}

inline Mover::TimedCourse Mover::CourseOf(const Move& move,
                                          kg_base::Cell from) const {
  const kg_base::Grid& grid = field_.grid;
  const int row = from.row + move.rows;
  const double lon_deg =
      grid.lon_deg()[from.col + move.cols] - grid.lon_deg()[from.col];
  const double lat_deg = grid.lat_deg()[row] - grid.lat_deg()[from.row];
  const kg_base::DegreesPerMetre& a = scale_[from.row];
  const kg_base::DegreesPerMetre& b = scale_[row];
  const double east_m = lon_deg * 2.0 / (a.lon_deg + b.lon_deg);
  const double north_m = lat_deg * 2.0 / (a.lat_deg + b.lat_deg);
  const double length_m = std::sqrt(east_m * east_m + north_m * north_m);
  return {length_m, east_m / length_m, north_m / length_m};
}

inline kg_base::Velocity Mover::Current(const Move::Sample& sample,
                                        kg_base::Cell from,
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
  const auto mean = [&](const kg_base::Raster& values) {
    const double s = grid_search::OrCalm(values[sw]) * (1.0 - sample.east) +
                     grid_search::OrCalm(values[sw + east]) * sample.east;
    const double n =
        grid_search::OrCalm(values[sw + north]) * (1.0 - sample.east) +
        grid_search::OrCalm(values[sw + north + east]) * sample.east;
    return s * (1.0 - sample.north) + n * sample.north;
  };
  const kg_base::FieldSlice& a = field_.slices[k];
  const kg_base::FieldSlice& b = field_.slices[l];
  const double early = boost_gain_ * (1.0 - late);
  kg_base::Velocity c{early * mean(a.east_mps), early * mean(a.north_mps)};
  if (late > 0.0) {
    c.east_mps += boost_gain_ * late * mean(b.east_mps);
    c.north_mps += boost_gain_ * late * mean(b.north_mps);
  }
  return c;
}

inline std::optional<double> Mover::Arrival(const Move& move,
                                            kg_base::Cell from,
                                            double depart_s) const {
  for (const kg_base::Cell& offset : move.touched) {
    if (!MayEnter({from.row + offset.row, from.col + offset.col})) {
      return std::nullopt;
    }
  }
  const TimedCourse course = CourseOf(move, from);
  const double part_m =
      course.length_m / static_cast<double>(move.samples.size());
  double time_s = depart_s;
  // Time to the middle of the next part, from the last rate.
  double half_s = 0.0;
  for (const Move::Sample& sample : move.samples) {
    const kg_base::Velocity c = Current(sample, from, time_s + half_s);
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

namespace grid_search {

inline constexpr int kTile = 16;
inline constexpr int kSourceRadius_cells = 3;

struct Node {
  double arrival_s = std::numeric_limits<double>::infinity();
  int parent = -1;
  bool settled = false;
};

// Search nodes, in tiles allocated on first access: a search that stays near
// its source costs nothing for the rest of the grid.
class Nodes {
 public:
  explicit Nodes(const kg_base::Grid& grid)
      : columns_((grid.cols() + kTile - 1) / kTile),
        tiles_(static_cast<std::size_t>(columns_) *
               ((grid.rows() + kTile - 1) / kTile)) {}

  Node& At(kg_base::Cell cell) {
    auto& tile = tiles_[static_cast<std::size_t>(cell.row / kTile) * columns_ +
                        cell.col / kTile];
    if (!tile) tile = std::make_unique<Node[]>(kTile * kTile);
    return tile[(cell.row % kTile) * kTile + cell.col % kTile];
  }

 private:
  int columns_;
  std::vector<std::unique_ptr<Node[]>> tiles_;
};

class Search {
 public:
  Search(const VoyageRequest& voyage, int neighbours)
      : flyer_(voyage),
        mover_(voyage),
        grid_(flyer_.grid()),
        nodes_(grid_),
        moves_(NeighbourMoves(neighbours)),
        from_(voyage.departure.from) {}

  GridReach Run() {
    Start();
    while (!queue_.empty()) {
      const auto [arrival_s, index] = queue_.top();
      queue_.pop();
      const kg_base::Cell cell{index / grid_.cols(), index % grid_.cols()};
      Node& node = nodes_.At(cell);
      if (node.settled) continue;
      node.settled = true;
      reach_.cells.push_back({index, arrival_s, node.parent});
      for (const Move& move : moves_) TryMove(move, cell, arrival_s);
    }
    std::sort(reach_.cells.begin(), reach_.cells.end(),
              [](const GridReachedCell& a, const GridReachedCell& b) {
                return a.index < b.index;
              });
    return std::move(reach_);
  }

 private:
  void Start() {
    const std::optional<kg_base::GridPoint> at = grid_.Locate(from_);
    if (!at) return;
    const kg_base::Cell cell = flyer_.CellOf(*at);
    if (!flyer_.IsOpen(cell)) return;
    for (int dr = -kSourceRadius_cells; dr <= kSourceRadius_cells; ++dr) {
      for (int dc = -kSourceRadius_cells; dc <= kSourceRadius_cells; ++dc) {
        TryLeg({cell.row + dr, cell.col + dc});
      }
    }
  }
  void TryLeg(kg_base::Cell to) {
    if (!mover_.MayEnter(to)) return;
    const auto end = flyer_.Fly({from_, grid_.Centre(to), 0.0}, kSearch);
    if (end) Improve(to, end->arrive_s, -1);
  }
  void TryMove(const Move& move, kg_base::Cell from, double depart_s) {
    const kg_base::Cell to{from.row + move.rows, from.col + move.cols};
    if (!mover_.MayEnter(to) || nodes_.At(to).settled) return;
    const auto arrival_s = mover_.Arrival(move, from, depart_s);
    if (arrival_s) {
      Improve(to, *arrival_s, static_cast<int>(grid_.Index(from)));
    }
  }
  void Improve(kg_base::Cell cell, double arrival_s, int parent) {
    Node& node = nodes_.At(cell);
    if (!(arrival_s < node.arrival_s)) return;
    node.arrival_s = arrival_s;
    node.parent = parent;
    queue_.push({arrival_s, static_cast<int>(grid_.Index(cell))});
  }

  using Entry = std::pair<double, int>;
  LegFlyer flyer_;
  Mover mover_;
  const kg_base::Grid& grid_;
  Nodes nodes_;
  std::vector<Move> moves_;
  kg_base::LonLat from_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
  GridReach reach_;
};

}  // namespace grid_search

inline GridReach GridSearch(const VoyageRequest& voyage, int neighbours) {
  return grid_search::Search(voyage, neighbours).Run();
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TESTING_GRID_SEARCH_H_
