#include "kg_compiler/data_plane/layer_table.h"

#include <algorithm>

#include "kg_base/common/parallel.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"

namespace kg_compiler {
namespace {

// Inverse distances between entries of an axis: from the previous to the next
// entry, and from each entry to the next.
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

std::vector<double> RowSteps_km(const kg_base::Grid& grid) {
  std::vector<double> steps;
  const std::vector<double>& lat_deg = grid.lat_deg();
  for (std::size_t r = 1; r < lat_deg.size(); ++r) {
    const double middle_deg = 0.5 * (lat_deg[r] + lat_deg[r - 1]);
    steps.push_back((lat_deg[r] - lat_deg[r - 1]) /
                    kg_base::LocalScale(middle_deg).lat_deg /
                    kg_base::kMetresPerKm);
  }
  return steps;
}

std::vector<double> ColSteps_deg(const kg_base::Grid& grid) {
  std::vector<double> steps;
  for (int c = 1; c < grid.cols(); ++c) {
    steps.push_back(grid.lon_deg()[c] - grid.lon_deg()[c - 1]);
  }
  return steps;
}

bool IsAllOpen(const RowBands<unsigned char>& state, const CellBox& box) {
  for (int r = box.row; r < box.row_end; ++r) {
    const unsigned char* row = state.Row(r);
    for (int c = box.col; c < box.col_end; ++c) {
      if (row[c] != kOpen) return false;
    }
  }
  return true;
}

int IndexOf(kg_mission::FrontOperator op) {
  return op == kg_mission::FrontOperator::kSobel ? 0 : 1;
}

// The row advanced by `cols` columns.
PassRow Shifted(PassRow row, int cols) {
  row.values += cols;
  row.state += cols;
  if (row.priors) row.priors += cols;
  if (row.inside) row.inside += cols;
  if (row.softness) row.softness += cols;
  return row;
}

}  // namespace

CellBox TileLayout::Box(int tile) const {
  const int row = tile / across * kBandRows;
  const int col = tile % across * width;
  return {row, std::min(row + kBandRows, rows), col,
          std::min(col + width, cols)};
}

LayerTable::LayerTable(const kg_base::Grid& grid, const kg_base::Raster& value)
    : tiling_{grid.rows(), grid.cols()} {
  for (const double lat_deg : grid.lat_deg()) {
    deg_per_km_.push_back(static_cast<float>(
        kg_base::LocalScale(lat_deg).lon_deg * kg_base::kMetresPerKm));
  }
  Inverse rows = InverseSteps(RowSteps_km(grid));
  Inverse cols = InverseSteps(ColSteps_deg(grid));
  per_km_ = std::move(rows.both);
  per_km_after_ = std::move(rows.after);
  per_deg_ = std::move(cols.both);
  per_deg_after_ = std::move(cols.after);
  FindGaps(value);
}

void LayerTable::FindGaps(const kg_base::Raster& value) {
  const int across = tiling_.across, cols = tiling_.cols;
  const int width = tiling_.width;
  // A segment has gaps if it, or a segment above or below, has a value that is
  // not finite, one column beyond its ends included.
  std::vector<unsigned char> own(static_cast<std::size_t>(tiling_.rows) *
                                 across);
  gaps_.assign(own.size(), 1);
  values_.assign(tiling_.size(), 0.0f);
  for (int r = 0; r < tiling_.rows; ++r) {
    const float* row = &value[static_cast<std::size_t>(r) * cols];
    for (int t = 0; t < across; ++t) {
      const int begin = t * width, end = std::min(begin + width, cols);
      const int first = std::max(begin - 1, 0), last = std::min(end + 1, cols);
      own[r * across + t] = !AllFinite(row + first, last - first);
      const ValueMagnitudes found = MagnitudesOf(row + begin, end - begin);
      float& max_value = values_[RowBands<float>::BandOf(r) * across + t];
      max_value = std::max(max_value, found.max_positive);
      max_abs_ = std::max(max_abs_, found.max_abs);
    }
  }
  for (int r = 1; r + 1 < tiling_.rows; ++r) {
    for (int t = 0; t < across; ++t) {
      gaps_[r * across + t] = own[(r - 1) * across + t] | own[r * across + t] |
                              own[(r + 1) * across + t];
    }
  }
}

FrontRows LayerTable::RowsAt(const kg_base::Raster& value, int row,
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

const LayerTable::GapFronts& LayerTable::GapFrontsOf(
    const kg_base::Raster& value, kg_mission::FrontOperator op) const {
  GapFronts& gaps = gap_fronts_[IndexOf(op)];
  std::call_once(gaps.made, [&] {
    const bool is_sobel = op == kg_mission::FrontOperator::kSobel;
    const int cols = tiling_.cols;
    const auto make = [&](int row, int col, int n, float* f) {
      FrontWithGaps(RowsAt(value, row, col), is_sobel,
                    {col > 0, col + n < cols}, n, f);
    };
    // Store F of the outermost columns, which lack a neighbour, and of segments
    // with gaps in or around them.
    gaps.first.resize(tiling_.rows);
    gaps.last.resize(tiling_.rows);
    float f[kTileCols];
    for (int r = 0; r < tiling_.rows; ++r) {
      make(r, 0, 1, &gaps.first[r]);
      make(r, cols - 1, 1, &gaps.last[r]);
      for (int col = 0; col < cols; col += tiling_.width) {
        gaps.begin.push_back(gaps.values.size());
        if (!HasGaps(r, col)) continue;
        const int n = std::min(tiling_.width, cols - col);
        make(r, col, n, f);
        gaps.values.insert(gaps.values.end(), f, f + n);
      }
    }
  });
  return gaps;
}

ValueExtremes LayerTable::Pass(const kg_base::Raster& value,
                               const Weights& weights, kg_base::Cell first,
                               int n, PassRow row, float* y) const {
  row.base = weights.base;
  row.front = weights.front;
  row.values =
      &value[static_cast<std::size_t>(first.row) * tiling_.cols + first.col];
  if (weights.front == 0.0f) return PassBase(row, n, y);
  const GapFronts& gaps = GapFrontsOf(value, weights.op);
  if (HasGaps(first.row, first.col)) {
    const std::size_t begin =
        gaps.begin[static_cast<std::size_t>(first.row) * tiling_.across +
                   first.col / tiling_.width];
    row.fronts = &gaps.values[begin + first.col % tiling_.width];
    return PassStored(row, n, y);
  }
  // The outermost columns have a neighbour on one side only.
  ValueExtremes found;
  int begin = 0, end = n;
  if (first.col == 0) {
    row.fronts = &gaps.first[first.row];
    found = PassStored(row, 1, y);
    begin = 1;
  }
  if (first.col + n == tiling_.cols && end > begin) {
    --end;
    PassRow last = Shifted(row, end);
    last.fronts = &gaps.last[first.row];
    found = Both(found, PassStored(last, 1, y + end));
  }
  if (begin >= end) return found;
  PassRow inner = Shifted(row, begin);
  inner.rows = RowsAt(value, first.row, first.col + begin);
  const bool is_sobel = weights.op == kg_mission::FrontOperator::kSobel;
  return Both(found, (is_sobel ? PassSobel : PassCentral)(inner, end - begin,
                                                          y + begin));
}

void LayerTable::Fronts(const kg_base::Raster& value,
                        kg_mission::FrontOperator op, kg_base::Cell first,
                        int n, float* f) const {
  const GapFronts& gaps = GapFrontsOf(value, op);
  if (HasGaps(first.row, first.col)) {
    const std::size_t begin =
        gaps.begin[static_cast<std::size_t>(first.row) * tiling_.across +
                   first.col / tiling_.width] +
        first.col % tiling_.width;
    std::copy(&gaps.values[begin], &gaps.values[begin] + n, f);
    return;
  }
  // The outermost columns come from the table, the rest is computed.
  const int begin = first.col == 0 ? 1 : 0;
  const int end = first.col + n == tiling_.cols ? n - 1 : n;
  const bool is_sobel = op == kg_mission::FrontOperator::kSobel;
  if (begin < end) {
    (is_sobel ? Sobel : Central)(RowsAt(value, first.row, first.col + begin),
                                 end - begin, f + begin);
  }
  if (end < n) f[n - 1] = gaps.last[first.row];
  if (begin > 0) f[0] = gaps.first[first.row];
}

const LayerTable::Tiles& LayerTable::FrontTiles(
    const kg_base::Raster& value, kg_mission::FrontOperator op) const {
  const int k = IndexOf(op);
  std::call_once(made_[k], [&] {
    fronts_[k].assign(tiling_.size(), 0.0f);
    kg_base::ForEachInParallel(tiling_.size(), [&](std::size_t tile) {
      const CellBox box = tiling_.Box(static_cast<int>(tile));
      float f[kTileCols];
      for (int r = box.row; r < box.row_end; ++r) {
        Fronts(value, op, {r, box.col}, box.cols(), f);
        fronts_[k][tile] =
            std::max(fronts_[k][tile], MaxPositive(f, box.cols()));
      }
    });
  });
  return fronts_[k];
}

// Visits tiles by descending maximum: usually the first one is all open, and
// its maximum is the result.
template <typename Evaluate>
float LayerTable::MaxOpen(const Tiles& tiles,
                          const RowBands<unsigned char>& state,
                          const Evaluate& evaluate) const {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(tiles.size()); ++i) {
    if (tiles[i] > 0.0f) order.push_back(i);
  }
  const auto below = [&](int a, int b) { return tiles[a] < tiles[b]; };
  std::make_heap(order.begin(), order.end(), below);
  float max_value = 0.0f;
  while (!order.empty() && tiles[order.front()] > max_value) {
    const int tile = order.front();
    std::pop_heap(order.begin(), order.end(), below);
    order.pop_back();
    const CellBox box = tiling_.Box(tile);
    max_value = std::max(max_value,
                         IsAllOpen(state, box) ? tiles[tile] : evaluate(box));
  }
  return max_value;
}

float LayerTable::MaxOpenValue(const kg_base::Raster& value,
                               const RowBands<unsigned char>& state) const {
  return MaxOpen(values_, state, [&](const CellBox& box) {
    float max_value = 0.0f;
    for (int r = box.row; r < box.row_end; ++r) {
      const std::size_t first =
          static_cast<std::size_t>(r) * tiling_.cols + box.col;
      max_value = std::max(
          max_value,
          MaxPositiveOpen(&value[first], state.Row(r) + box.col, box.cols()));
    }
    return max_value;
  });
}

float LayerTable::MaxOpenFront(const kg_base::Raster& value,
                               kg_mission::FrontOperator op,
                               const RowBands<unsigned char>& state) const {
  return MaxOpen(FrontTiles(value, op), state, [&](const CellBox& box) {
    float max_value = 0.0f;
    float f[kTileCols];
    for (int r = box.row; r < box.row_end; ++r) {
      Fronts(value, op, {r, box.col}, box.cols(), f);
      max_value = std::max(
          max_value, MaxPositiveOpen(f, state.Row(r) + box.col, box.cols()));
    }
    return max_value;
  });
}

}  // namespace kg_compiler
