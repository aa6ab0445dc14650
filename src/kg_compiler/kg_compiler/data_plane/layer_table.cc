#include "kg_compiler/data_plane/layer_table.h"

#include <algorithm>

#include "kg_core/base/parallel.h"
#include "kg_core/base/units.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

// 1 / steps between entries of an axis: over two of them, and over the one to
// the next.
struct Inverse {
  std::vector<float> both, after;
};

Inverse InverseSteps(const std::vector<double>& steps) {
  Inverse inverse;
  const std::size_t size = steps.size() + 1;
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_inside = i > 0 && i + 1 < size;
    inverse.both.push_back(
        is_inside ? static_cast<float>(1.0 / (steps[i - 1] + steps[i])) : 0.f);
    inverse.after.push_back(i + 1 < size ? static_cast<float>(1.0 / steps[i])
                                         : 0.f);
  }
  return inverse;
}

std::vector<double> RowSteps_km(const kg_core::Grid& grid) {
  std::vector<double> steps;
  const std::vector<double>& lat_deg = grid.lat_deg();
  for (std::size_t r = 1; r < lat_deg.size(); ++r) {
    const double middle_deg = 0.5 * (lat_deg[r] + lat_deg[r - 1]);
    steps.push_back((lat_deg[r] - lat_deg[r - 1]) /
                    kg_core::LocalScale(middle_deg).lat_deg /
                    kg_core::kMetresPerKm);
  }
  return steps;
}

std::vector<double> ColSteps_deg(const kg_core::Grid& grid) {
  std::vector<double> steps;
  for (int c = 1; c < grid.cols(); ++c) {
    steps.push_back(grid.lon_deg()[c] - grid.lon_deg()[c - 1]);
  }
  return steps;
}

bool IsAllOpen(const Bands<unsigned char>& state, const GridBox& box) {
  for (int r = box.row; r < box.row_end; ++r) {
    const unsigned char* row = state.Row(r);
    for (int c = box.col; c < box.col_end; ++c) {
      if (row[c] != kOpen) return false;
    }
  }
  return true;
}

}  // namespace

GridBox Tiling::Box(int tile) const {
  const int row = tile / across() * kBandRows;
  const int col = tile % across() * kTileCols;
  return {row, std::min(row + kBandRows, rows), col,
          std::min(col + kTileCols, cols)};
}

LayerTable::LayerTable(const kg_core::Grid& grid, const kg_core::Raster& value)
    : tiling_{grid.rows(), grid.cols()} {
  for (const double lat_deg : grid.lat_deg()) {
    deg_per_km_.push_back(static_cast<float>(
        kg_core::LocalScale(lat_deg).lon_deg * kg_core::kMetresPerKm));
  }
  Inverse rows = InverseSteps(RowSteps_km(grid));
  Inverse cols = InverseSteps(ColSteps_deg(grid));
  per_km_ = std::move(rows.both);
  per_km_after_ = std::move(rows.after);
  per_deg_ = std::move(cols.both);
  per_deg_after_ = std::move(cols.after);
  FindGaps(value);
}

void LayerTable::FindGaps(const kg_core::Raster& value) {
  const int across = tiling_.across(), cols = tiling_.cols;
  std::vector<unsigned char> own(static_cast<std::size_t>(tiling_.rows) *
                                 across);
  gaps_.assign(own.size(), 1);
  values_.assign(tiling_.size(), 0.0f);
  for (int r = 0; r < tiling_.rows; ++r) {
    const float* row = &value[static_cast<std::size_t>(r) * cols];
    for (int t = 0; t < across; ++t) {
      const int begin = t * kTileCols, end = std::min(begin + kTileCols, cols);
      const int first = std::max(begin - 1, 0), last = std::min(end + 1, cols);
      own[r * across + t] = !AllFinite(row + first, last - first);
      const Magnitudes found = MagnitudesOf(row + begin, end - begin);
      float& most = values_[Bands<float>::BandOf(r) * across + t];
      most = std::max(most, found.most);
      largest_ = std::max(largest_, found.largest);
    }
  }
  for (int r = 1; r + 1 < tiling_.rows; ++r) {
    for (int t = 0; t < across; ++t) {
      gaps_[r * across + t] = own[(r - 1) * across + t] | own[r * across + t] |
                              own[(r + 1) * across + t];
    }
  }
}

FrontRows LayerTable::RowsAt(const kg_core::Raster& value, int row,
                             int col) const {
  const std::size_t cols = static_cast<std::size_t>(tiling_.cols);
  const float* middle = &value[row * cols + col];
  const bool has_south = row > 0, has_north = row + 1 < tiling_.rows;
  FrontRows rows;
  rows.south = has_south ? middle - cols : nullptr;
  rows.middle = middle;
  rows.north = has_north ? middle + cols : nullptr;
  rows.south_deg_per_km = has_south ? deg_per_km_[row - 1] : 0.0f;
  rows.middle_deg_per_km = deg_per_km_[row];
  rows.north_deg_per_km = has_north ? deg_per_km_[row + 1] : 0.0f;
  rows.per_km = per_km_[row];
  rows.per_km_south = has_south ? per_km_after_[row - 1] : 0.0f;
  rows.per_km_north = per_km_after_[row];
  rows.per_deg = &per_deg_[col];
  rows.per_deg_after = &per_deg_after_[col];
  return rows;
}

void LayerTable::Blend(const kg_core::Raster& value, const Weights& weights,
                       kg_core::Cell first, int n, float* v) const {
  const int row = first.row, col = first.col;
  const FrontRows rows = RowsAt(value, row, col);
  if (weights.front == 0.0f) {
    BlendBase(rows.middle, weights.base, n, v);
    return;
  }
  const bool is_sobel = weights.op == kg_core::FrontOperator::kSobel;
  const auto with_gaps = [&](int begin, int end) {
    const FrontRows part = RowsAt(value, row, col + begin);
    BlendWithGaps(part, is_sobel, {col + begin > 0, col + end < tiling_.cols},
                  weights.base, weights.front, end - begin, v + begin);
  };
  if (gaps_[row * tiling_.across() + col / kTileCols]) {
    with_gaps(0, n);
    return;
  }
  // The outermost columns have a neighbour on one side only.
  const int begin = col == 0 ? 1 : 0;
  const int end = col + n == tiling_.cols ? n - 1 : n;
  if (begin > 0) with_gaps(0, 1);
  if (end < n && end >= begin) with_gaps(end, n);
  if (begin >= end) return;
  const FrontRows inner = begin > 0 ? RowsAt(value, row, col + begin) : rows;
  if (is_sobel) {
    BlendSobel(inner, weights.base, weights.front, end - begin, v + begin);
  } else {
    BlendCentral(inner, weights.base, weights.front, end - begin, v + begin);
  }
}

const LayerTable::Tiles& LayerTable::FrontTiles(
    const kg_core::Raster& value, kg_core::FrontOperator op) const {
  const int k = op == kg_core::FrontOperator::kSobel ? 0 : 1;
  std::call_once(made_[k], [&] {
    fronts_[k].assign(tiling_.size(), 0.0f);
    kg_core::ForEachInParallel(tiling_.size(), [&](std::size_t tile) {
      const GridBox box = tiling_.Box(static_cast<int>(tile));
      float f[kTileCols];
      for (int r = box.row; r < box.row_end; ++r) {
        Blend(value, {0.0f, 1.0f, op}, {r, box.col}, box.cols(), f);
        fronts_[k][tile] = std::max(fronts_[k][tile], MostOf(f, box.cols()));
      }
    });
  });
  return fronts_[k];
}

// The tile with the largest first: usually all of it is open, and that is it.
template <typename Evaluate>
float LayerTable::Most(const Tiles& tiles, const Bands<unsigned char>& state,
                       const Evaluate& evaluate) const {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(tiles.size()); ++i) {
    if (tiles[i] > 0.0f) order.push_back(i);
  }
  const auto below = [&](int a, int b) { return tiles[a] < tiles[b]; };
  std::make_heap(order.begin(), order.end(), below);
  float most = 0.0f;
  while (!order.empty() && tiles[order.front()] > most) {
    const int tile = order.front();
    std::pop_heap(order.begin(), order.end(), below);
    order.pop_back();
    const GridBox box = tiling_.Box(tile);
    most = std::max(most, IsAllOpen(state, box) ? tiles[tile] : evaluate(box));
  }
  return most;
}

float LayerTable::MostValue(const kg_core::Raster& value,
                            const Bands<unsigned char>& state) const {
  return Most(values_, state, [&](const GridBox& box) {
    float most = 0.0f;
    for (int r = box.row; r < box.row_end; ++r) {
      const std::size_t first =
          static_cast<std::size_t>(r) * tiling_.cols + box.col;
      most = std::max(
          most, MostOpen(&value[first], state.Row(r) + box.col, box.cols()));
    }
    return most;
  });
}

float LayerTable::MostFront(const kg_core::Raster& value,
                            kg_core::FrontOperator op,
                            const Bands<unsigned char>& state) const {
  return Most(FrontTiles(value, op), state, [&](const GridBox& box) {
    float most = 0.0f;
    float f[kTileCols];
    for (int r = box.row; r < box.row_end; ++r) {
      Blend(value, {0.0f, 1.0f, op}, {r, box.col}, box.cols(), f);
      most = std::max(most, MostOpen(f, state.Row(r) + box.col, box.cols()));
    }
    return most;
  });
}

}  // namespace kg_compiler
