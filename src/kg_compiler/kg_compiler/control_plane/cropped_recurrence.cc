#include "kg_compiler/control_plane/cropped_recurrence.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/control_plane/window_surface.h"

namespace kg_compiler {
namespace {

constexpr double kMaxRadius_m = 500e3;  // Larger discs see the whole grid.

CellBox BoxOf(const std::vector<int>& cells, int cols) {
  CellBox box{cells.front() / cols, cells.back() / cols + 1, cols, 0};
  for (const int cell : cells) {
    box.col = std::min(box.col, cell % cols);
    box.col_end = std::max(box.col_end, cell % cols + 1);
  }
  return box;
}

double North_m(const kg_base::Grid& grid, int from, int to) {
  const double a = grid.lat_deg()[from], b = grid.lat_deg()[to];
  return (b - a) / kg_base::LocalScale(0.5 * (a + b)).lat_deg;
}

// The box extended by `radius_m` and one more cell on every side.
CellBox GrowBy_m(CellBox box, const kg_base::Grid& grid, double radius_m) {
  const int south = box.row, north = box.row_end - 1;
  while (box.row > 0 && North_m(grid, box.row, south) <= radius_m) --box.row;
  while (box.row_end < grid.rows() &&
         North_m(grid, north, box.row_end - 1) <= radius_m) {
    ++box.row_end;
  }
  double lon_deg = 0.0;  // Largest east-west extent of the radius in any row.
  for (int row = box.row; row < box.row_end; ++row) {
    const double scale = kg_base::LocalScale(grid.lat_deg()[row]).lon_deg;
    lon_deg = std::max(lon_deg, radius_m * scale);
  }
  const std::vector<double>& lon = grid.lon_deg();
  const double west = lon[box.col] - lon_deg;
  const double east = lon[box.col_end - 1] + lon_deg;
  while (box.col > 0 && lon[box.col] >= west) --box.col;
  while (box.col_end < grid.cols() && lon[box.col_end - 1] <= east) {
    ++box.col_end;
  }
  return box;
}

template <typename T>
std::vector<T> Cut(const std::vector<T>& whole, int cols, const CellBox& box) {
  std::vector<T> cut;
  cut.reserve(static_cast<std::size_t>(box.row_end - box.row) *
              (box.col_end - box.col));
  for (int row = box.row; row < box.row_end; ++row) {
    const auto begin = whole.begin() + static_cast<std::ptrdiff_t>(row) * cols;
    cut.insert(cut.end(), begin + box.col, begin + box.col_end);
  }
  return cut;
}

// Picks computed on the part, with cells converted to the whole grid.
std::vector<RecurrencePick> PicksOf(const kg_base::Grid& grid,
                                    const PickMemo& memo) {
  const auto axis = [](const std::vector<double>& whole, int begin, int end) {
    return std::vector<double>(whole.begin() + begin, whole.begin() + end);
  };
  const CellBox& box = memo.box;
  const kg_base::Grid part(axis(grid.lon_deg(), box.col, box.col_end),
                           axis(grid.lat_deg(), box.row, box.row_end));
  std::vector<RecurrencePick> picks =
      ProximalRecurrence(part, memo.utility, memo.allowed, memo.options);
  for (RecurrencePick& pick : picks) {
    pick.cell = {pick.cell.row + box.row, pick.cell.col + box.col};
    for (int& cell : pick.footprint) {
      cell = static_cast<int>(grid.Index(
          {cell / part.cols() + box.row, cell % part.cols() + box.col}));
    }
  }
  return picks;
}

auto Tie(const RecurrenceOptions& o) {
  return std::tie(o.radius_m, o.spacing_m, o.count);
}
auto Tie(const CellBox& b) {
  return std::tie(b.row, b.row_end, b.col, b.col_end);
}

bool SameInputs(const PickMemo& a, const PickMemo& b) {
  return Tie(a.box) == Tie(b.box) && Tie(a.options) == Tie(b.options) &&
         a.allowed == b.allowed && a.utility == b.utility;
}

// Grids have two rows and two columns at least.
CellBox SeenFrom(const CellBox& cells, const kg_base::Grid& grid,
                 double radius_m) {
  if (!(radius_m < kMaxRadius_m)) return {0, grid.rows(), 0, grid.cols()};
  CellBox box = GrowBy_m(cells, grid, radius_m);
  if (box.row_end - box.row < 2) box.row > 0 ? --box.row : ++box.row_end;
  if (box.col_end - box.col < 2) box.col > 0 ? --box.col : ++box.col_end;
  return Grown(box, 0, 0, grid);
}

}  // namespace

const std::vector<RecurrencePick>& RecurrenceWithin(
    const kg_base::Grid& grid, const kg_base::Raster& utility,
    const std::vector<int>& allowed, const RecurrenceOptions& options,
    PickMemo* memo) {
  if (utility.size() != grid.size()) {
    throw std::logic_error("utility is not of the grid's size");
  }
  PickMemo now;
  now.options = options;
  if (!allowed.empty()) {
    now.box = SeenFrom(BoxOf(allowed, grid.cols()), grid, options.radius_m);
    now.utility = Cut(utility, grid.cols(), now.box);
    kg_base::Mask mask(grid.size(), 0);
    for (const int cell : allowed) mask[cell] = 1;
    now.allowed = Cut(mask, grid.cols(), now.box);
  }
  // Bit-identical inputs give the same picks.
  if (SameInputs(now, *memo)) return memo->picks;
  if (!allowed.empty()) now.picks = PicksOf(grid, now);
  *memo = std::move(now);
  return memo->picks;
}

}  // namespace kg_compiler
