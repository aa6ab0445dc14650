#include "kg_compiler/traversal/hazard_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kg_compiler/data_plane/distance_transform.h"

namespace kg_compiler {
namespace {

// Range of indices whose centres lie within `reach` of [first, last].
struct Span {
  int begin, end;  // Half open.
};
Span Widen(const std::vector<double>& centres, int first, int last,
           double reach) {
  const auto begin =
      std::lower_bound(centres.begin(), centres.end(), centres[first] - reach);
  const auto end =
      std::upper_bound(centres.begin(), centres.end(), centres[last] + reach);
  return {static_cast<int>(begin - centres.begin()),
          static_cast<int>(end - centres.begin())};
}

// A rectangular part of the grid with its mask of closed cells.
struct Patch {
  Patch(const kg_base::Grid& grid, const kg_base::Mask& open, Span r, Span c)
      : rows(r), cols(c) {
    closed.reserve(static_cast<std::size_t>(r.end - r.begin) *
                   (c.end - c.begin));
    for (int row = r.begin; row < r.end; ++row) {
      for (int col = c.begin; col < c.end; ++col) {
        const bool shut = open[grid.Index({row, col})] != 1;
        closed.push_back(shut);
        any = any || shut;
      }
    }
  }
  kg_base::Grid Local(const kg_base::Grid& grid) const {
    const auto part = [](const std::vector<double>& axis, Span span) {
      return std::vector<double>(axis.begin() + span.begin,
                                 axis.begin() + span.end);
    };
    return {part(grid.lon_deg(), cols), part(grid.lat_deg(), rows)};
  }

  Span rows, cols;
  kg_base::Mask closed;
  bool any = false;
};

// Extends a span to at least two centres, the minimum for a Grid.
Span AtLeastTwo(Span span, int size) {
  if (span.end - span.begin >= 2) return span;
  return span.begin > 0 ? Span{span.begin - 1, span.end}
                        : Span{span.begin, std::min(span.end + 1, size)};
}

}  // namespace

HazardMap::HazardMap(const kg_base::Grid& grid, const kg_base::Mask& open,
                     kg_base::Raster attenuation, double range_m)
    : grid_(grid),
      open_(open),
      attenuation_(std::move(attenuation)),
      range_m_(range_m),
      tile_cols_((grid.cols() + kTile - 1) / kTile),
      tiles_(new Tile[static_cast<std::size_t>(tile_cols_) *
                      ((grid.rows() + kTile - 1) / kTile)]) {}

void HazardMap::Make(int tile_row, int tile_col, Tile* tile) const {
  const int r0 = tile_row * kTile, c0 = tile_col * kTile;
  const int r1 = std::min(r0 + kTile, grid_.rows()) - 1;
  const int c1 = std::min(c0 + kTile, grid_.cols()) - 1;
  // Patch = tile plus the reach of the first term on every side, so that the
  // distances inside the tile are exact.
  const double reach_m = kRanges * range_m_;
  const double north_deg =
      reach_m / std::min(grid_.MetresPerRow(r0) / grid_.lat_axis().Spacing(r0),
                         grid_.MetresPerRow(r1) / grid_.lat_axis().Spacing(r1));
  const Span rows =
      AtLeastTwo(Widen(grid_.lat_deg(), r0, r1, north_deg), grid_.rows());
  // The row nearest to a pole has the shortest degrees of longitude.
  const double east_deg = reach_m /
                          std::min(grid_.MetresPerCol(rows.begin, c0),
                                   grid_.MetresPerCol(rows.end - 1, c0)) *
                          grid_.lon_axis().Spacing(c0);
  const Span cols =
      AtLeastTwo(Widen(grid_.lon_deg(), c0, c1, east_deg), grid_.cols());
  const Patch patch(grid_, open_, rows, cols);
  if (!patch.any) return;
  const kg_base::Grid local = patch.Local(grid_);
  const std::vector<double> distance_m = DistanceTo_m(local, patch.closed);
  tile->near.reserve(static_cast<std::size_t>(kTile) * kTile);
  for (int row = r0; row <= r1; ++row) {
    for (int col = c0; col < c0 + kTile; ++col) {
      const double d_m =
          col <= c1
              ? distance_m[local.Index({row - rows.begin, col - cols.begin})]
              : reach_m;
      tile->near.push_back(
          d_m < reach_m ? static_cast<float>(std::exp(-d_m / range_m_)) : 0.0f);
    }
  }
}

double HazardMap::At(kg_base::Cell cell) const {
  if (!grid_.Contains(cell)) return 1.0;
  const std::size_t i = grid_.Index(cell);
  const double soft = std::clamp(1.0 - attenuation_[i], 0.0, 1.0);
  if (!(range_m_ > 0.0)) return open_[i] == 1 ? soft : 1.0;
  const int tile_row = cell.row / kTile, tile_col = cell.col / kTile;
  Tile& tile =
      tiles_[static_cast<std::size_t>(tile_row) * tile_cols_ + tile_col];
  std::call_once(tile.made, [&] { Make(tile_row, tile_col, &tile); });
  if (tile.near.empty()) return soft;
  const double near = tile.near[(cell.row % kTile) * kTile + cell.col % kTile];
  return std::max(near, soft);
}

}  // namespace kg_compiler
