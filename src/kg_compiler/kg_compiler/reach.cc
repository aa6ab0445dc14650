// ComputeReach: Dijkstra's search over moves to grid neighbours, their times
// flown in the current at the time one sets out. Arriving earlier is never
// worse (one may follow the later track and stay ahead on it), so the first
// arrival settled is the earliest of these moves.

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <stdexcept>

#include "kg_compiler/leg.h"
#include "kg_compiler/traversal.h"

namespace kg_compiler {
namespace {

constexpr int kTile = 16;
constexpr int kSourceRadius_cells = 3;

struct Node {
  double arrival_s = std::numeric_limits<double>::infinity();
  int parent = -1;
  bool settled = false;
};

// Nodes of the cells touched, in tiles made when first touched: a search that
// stays near its source costs nothing for the rest of the grid.
class Nodes {
 public:
  explicit Nodes(const kg_core::Grid& grid)
      : columns_((grid.cols() + kTile - 1) / kTile),
        tiles_(static_cast<std::size_t>(columns_) *
               ((grid.rows() + kTile - 1) / kTile)) {}

  Node& At(kg_core::Cell cell) {
    auto& tile = tiles_[static_cast<std::size_t>(cell.row / kTile) * columns_ +
                        cell.col / kTile];
    if (!tile) tile = std::make_unique<Node[]>(kTile * kTile);
    return tile[(cell.row % kTile) * kTile + cell.col % kTile];
  }

 private:
  int columns_;
  std::vector<std::unique_ptr<Node[]>> tiles_;
};

// Steps to neighbours: coprime offsets, up to (2, 1) for 16, (3, 2) for 32.
std::vector<kg_core::Cell> Offsets(int neighbours) {
  const int longest = neighbours == 16 ? 2 : 3;
  std::vector<kg_core::Cell> offsets;
  for (int dr = -longest; dr <= longest; ++dr) {
    for (int dc = -longest; dc <= longest; ++dc) {
      const int a = std::abs(dr), b = std::abs(dc);
      const bool coprime = a + b == 1 || (a == 1 && b >= 1) ||
                           (b == 1 && a >= 1) || (a * b == 6);
      if (coprime) offsets.push_back({dr, dc});
    }
  }
  return offsets;
}

class Search {
 public:
  Search(const TraversalWorld& world, const MotionModel& motion,
         const Departure& departure, int neighbours)
      : flyer_(world, motion, departure),
        grid_(flyer_.grid()),
        nodes_(grid_),
        offsets_(Offsets(neighbours)),
        from_(departure.from) {}

  Reach Run() {
    Start();
    while (!queue_.empty()) {
      const auto [arrival_s, index] = queue_.top();
      queue_.pop();
      const kg_core::Cell cell{index / grid_.cols(), index % grid_.cols()};
      Node& node = nodes_.At(cell);
      if (node.settled) continue;
      node.settled = true;
      reach_.cells.push_back({index, arrival_s, node.parent});
      for (const kg_core::Cell& offset : offsets_) {
        Try({grid_.Centre(cell), {}, arrival_s}, index,
            {cell.row + offset.row, cell.col + offset.col});
      }
    }
    std::sort(reach_.cells.begin(), reach_.cells.end(),
              [](const ReachedCell& a, const ReachedCell& b) {
                return a.index < b.index;
              });
    return std::move(reach_);
  }

 private:
  void Start() {
    const std::optional<kg_core::GridPoint> at = grid_.Locate(from_);
    if (!at) return;
    const kg_core::Cell cell = flyer_.CellOf(*at);
    if (!flyer_.IsOpen(cell)) return;
    for (int dr = -kSourceRadius_cells; dr <= kSourceRadius_cells; ++dr) {
      for (int dc = -kSourceRadius_cells; dc <= kSourceRadius_cells; ++dc) {
        Try({from_, {}, 0.0}, -1, {cell.row + dr, cell.col + dc});
      }
    }
  }
  void Try(Leg leg, int parent, kg_core::Cell to) {
    if (!grid_.Contains(to) || !flyer_.IsOpen(to)) return;
    Node& node = nodes_.At(to);
    if (node.settled) return;
    leg.to = grid_.Centre(to);
    const std::optional<LegEnd> end = flyer_.Fly(leg, kSearch);
    if (!end || !(end->arrive_s < node.arrival_s)) return;
    node.arrival_s = end->arrive_s;
    node.parent = parent;
    queue_.push({end->arrive_s, static_cast<int>(grid_.Index(to))});
  }

  using Entry = std::pair<double, int>;
  LegFlyer flyer_;
  const kg_core::Grid& grid_;
  Nodes nodes_;
  std::vector<kg_core::Cell> offsets_;
  kg_core::LonLat from_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
  Reach reach_;
};

}  // namespace

const ReachedCell* Reach::Find(int index) const {
  const auto at = std::lower_bound(
      cells.begin(), cells.end(), index,
      [](const ReachedCell& cell, int wanted) { return cell.index < wanted; });
  return at != cells.end() && at->index == index ? &*at : nullptr;
}

Reach ComputeReach(const TraversalWorld& world, const MotionModel& motion,
                   const Departure& departure, int neighbours) {
  if (neighbours != 16 && neighbours != 32) {
    throw std::logic_error("a search has 16 or 32 neighbours");
  }
  return Search(world, motion, departure, neighbours).Run();
}

}  // namespace kg_compiler
