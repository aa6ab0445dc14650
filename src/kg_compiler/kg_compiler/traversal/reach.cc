// ComputeReach: Dijkstra's search over moves to grid neighbours, their times
// flown in the current at the time one sets out. Arriving earlier is never
// worse (one may follow the later track and stay ahead on it), so the first
// arrival settled is the earliest of these moves.

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>

#include "kg_compiler/traversal/leg.h"
#include "kg_compiler/traversal/moves.h"
#include "kg_compiler/traversal/traversal.h"

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

class Search {
 public:
  Search(const Voyage& voyage, int neighbours)
      : flyer_(voyage),
        mover_(voyage),
        grid_(flyer_.grid()),
        nodes_(grid_),
        moves_(NeighbourMoves(neighbours)),
        from_(voyage.departure.from) {}

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
      for (const Move& move : moves_) TryMove(move, cell, arrival_s);
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
        TryLeg({cell.row + dr, cell.col + dc});
      }
    }
  }
  void TryLeg(kg_core::Cell to) {
    if (!mover_.MayEnter(to)) return;
    const auto end = flyer_.Fly({from_, grid_.Centre(to), 0.0}, kSearch);
    if (end) Improve(to, end->arrive_s, -1);
  }
  void TryMove(const Move& move, kg_core::Cell from, double depart_s) {
    const kg_core::Cell to{from.row + move.rows, from.col + move.cols};
    if (!mover_.MayEnter(to) || nodes_.At(to).settled) return;
    const auto arrival_s = mover_.Arrival(move, from, depart_s);
    if (arrival_s) {
      Improve(to, *arrival_s, static_cast<int>(grid_.Index(from)));
    }
  }
  void Improve(kg_core::Cell cell, double arrival_s, int parent) {
    Node& node = nodes_.At(cell);
    if (!(arrival_s < node.arrival_s)) return;
    node.arrival_s = arrival_s;
    node.parent = parent;
    queue_.push({arrival_s, static_cast<int>(grid_.Index(cell))});
  }

  using Entry = std::pair<double, int>;
  LegFlyer flyer_;
  Mover mover_;
  const kg_core::Grid& grid_;
  Nodes nodes_;
  std::vector<Move> moves_;
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

Reach ComputeReach(const Voyage& voyage) {
  Reach reach = Search(voyage, 32).Run();
  const kg_core::Grid& grid = voyage.world.field->grid;
  reach.read = {0, grid.rows(), 0, grid.cols()};
  return reach;
}

}  // namespace kg_compiler
