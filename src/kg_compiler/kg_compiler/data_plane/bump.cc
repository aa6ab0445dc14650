#include "kg_compiler/data_plane/bump.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kg_base/geo/geodesy.h"

namespace kg_compiler {
namespace {

// Cells [first, end) of an axis whose centres lie within [low, high].
struct IndexSpan {
  int first, end;
};

IndexSpan SpanBetween(const std::vector<double>& centres, double low,
                      double high) {
  const auto first = std::lower_bound(centres.begin(), centres.end(), low);
  const auto end = std::upper_bound(first, centres.end(), high);
  return {static_cast<int>(first - centres.begin()),
          static_cast<int>(end - centres.begin())};
}

// A row of a bump: its columns and the scale of the row.
struct BumpRow {
  IndexSpan cols;
  double north_m;
  double lon_deg_per_m;
};

IndexSpan BumpRows(const kg_base::Grid& grid, const kg_mission::Event& event) {
  const double lat_deg = event.position.lat_deg;
  const double reach_deg =
      kBumpReach_sigmas * event.radius_m * kg_base::LocalScale(lat_deg).lat_deg;
  return SpanBetween(grid.lat_deg(), lat_deg - reach_deg, lat_deg + reach_deg);
}

BumpRow RowOf(const kg_base::Grid& grid, const kg_mission::Event& event,
              int row) {
  const kg_base::LonLat at = event.position;
  const double lat_deg = grid.lat_deg()[row];
  const kg_base::DegreesPerMetre scale =
      kg_base::LocalScale(0.5 * (lat_deg + at.lat_deg));
  const double reach_deg = kBumpReach_sigmas * event.radius_m * scale.lon_deg;
  return {SpanBetween(grid.lon_deg(), at.lon_deg - reach_deg,
                      at.lon_deg + reach_deg),
          (lat_deg - at.lat_deg) / scale.lat_deg, scale.lon_deg};
}

}  // namespace

double Gaussian(double distance_m, double sigma_m) {
  const double z = distance_m / sigma_m;
  return std::exp(-0.5 * z * z);
}

CellBox BoxWithin(const kg_base::Grid& grid, const CellBox& box,
                  double reach_m) {
  const double south_deg = grid.lat_deg()[box.row];
  const double north_deg = grid.lat_deg()[box.row_end - 1];
  const kg_base::DegreesPerMetre south = kg_base::LocalScale(south_deg);
  const kg_base::DegreesPerMetre north = kg_base::LocalScale(north_deg);
  const double lat_deg = reach_m * std::max(south.lat_deg, north.lat_deg);
  const double lon_deg = reach_m * std::max(south.lon_deg, north.lon_deg);
  const IndexSpan rows =
      SpanBetween(grid.lat_deg(), south_deg - lat_deg, north_deg + lat_deg);
  const IndexSpan cols =
      SpanBetween(grid.lon_deg(), grid.lon_deg()[box.col] - lon_deg,
                  grid.lon_deg()[box.col_end - 1] + lon_deg);
  return Grown({rows.first, rows.end, cols.first, cols.end}, 1, grid);
}

CellBox BumpBox(const kg_base::Grid& grid, const kg_mission::Event& event) {
  const IndexSpan rows = BumpRows(grid, event);
  CellBox box{rows.first, rows.end, grid.cols(), 0};
  for (int r = rows.first; r < rows.end; ++r) {
    const BumpRow row = RowOf(grid, event, r);
    if (row.cols.first >= row.cols.end) continue;
    box.col = std::min(box.col, row.cols.first);
    box.col_end = std::max(box.col_end, row.cols.end);
  }
  return box.empty() ? CellBox{} : box;
}

void ForEachBumpCell(const kg_base::Grid& grid, const kg_mission::Event& event,
                     const std::function<void(kg_base::Cell, double)>& add) {
  const IndexSpan rows = BumpRows(grid, event);
  for (int r = rows.first; r < rows.end; ++r) {
    const BumpRow row = RowOf(grid, event, r);
    for (int c = row.cols.first; c < row.cols.end; ++c) {
      const double east_m =
          (grid.lon_deg()[c] - event.position.lon_deg) / row.lon_deg_per_m;
      const double d_m = std::sqrt(east_m * east_m + row.north_m * row.north_m);
      add({r, c}, Gaussian(d_m, event.radius_m));
    }
  }
}

}  // namespace kg_compiler
