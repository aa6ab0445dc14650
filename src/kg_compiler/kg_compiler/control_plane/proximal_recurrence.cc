#include "kg_compiler/control_plane/proximal_recurrence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

constexpr int kUtilityBits = 31;  // Sums of 2^32 cells fit in 63 bits.

struct Columns {
  int first = 0;  // Allowed columns of a row: [first, last).
  int last = 0;
};

class Recurrence {
 public:
  Recurrence(const kg_core::Grid& grid, const kg_core::Raster& utility,
             const kg_core::Mask& allowed, double radius_m)
      : grid_(grid), allowed_(allowed), radius_m_(radius_m) {
    Quantise(utility);
    for (int r = 0; r < grid.rows(); ++r) {
      m_per_lon_deg_.push_back(1.0 /
                               kg_core::LocalScale(grid.lat_deg()[r]).lon_deg);
    }
    sums_.assign(static_cast<std::size_t>(grid.rows()) * (grid.cols() + 1), 0);
    response_.assign(grid.size(), 0);
    best_.resize(grid.rows());
    for (int r = 0; r < grid.rows(); ++r) SumRow(r);
    for (int r = 0; r < grid.rows(); ++r) Respond(r);
  }

  // The best allowed cell, the first of equals.
  std::optional<Pick> Best() const {
    std::int64_t most = 0;
    kg_core::Cell cell;
    for (int r = 0; r < grid_.rows(); ++r) {
      if (best_[r].response <= most) continue;
      most = best_[r].response;
      cell = {r, best_[r].col};
    }
    if (most == 0) return std::nullopt;
    return Pick{cell, static_cast<double>(most) * unit_, Footprint(cell)};
  }

  // Blanks the disc around a pick and forbids it to later picks.
  void Blank(kg_core::Cell pick, double spacing_m) {
    const Columns rows = RowsWithin(pick.row, spacing_m);
    for (int r = rows.first; r < rows.last; ++r) {
      for (int c = 0; c < grid_.cols(); ++c) {
        if (!Within(pick.row, r, LonGap(pick.col, c), spacing_m)) continue;
        utility_[grid_.Index({r, c})] = 0;
        allowed_[grid_.Index({r, c})] = 0;
      }
      SumRow(r);
    }
    const Columns seen = {RowsWithin(rows.first, radius_m_).first,
                          RowsWithin(rows.last - 1, radius_m_).last};
    for (int r = seen.first; r < seen.last; ++r) Respond(r);
  }

 private:
  struct RowBest {
    std::int64_t response = 0;
    int col = 0;
  };

  // Utilities as whole multiples of a power of two: their sums are exact, so
  // that equal discs tie whatever the order of summing.
  void Quantise(const kg_core::Raster& utility) {
    float most = 0.0f;
    for (const float u : utility) most = std::max(most, u);
    int exponent = 0;
    std::frexp(most, &exponent);
    unit_ = std::ldexp(1.0, exponent - kUtilityBits);
    utility_.reserve(utility.size());
    for (const float u : utility) {
      utility_.push_back(std::llround(static_cast<double>(u) / unit_));
    }
  }
  double LonGap(int a, int b) const {
    return std::abs(grid_.lon_deg()[a] - grid_.lon_deg()[b]);
  }
  double North_m(int from, int to) const {
    const double middle_deg =
        0.5 * (grid_.lat_deg()[from] + grid_.lat_deg()[to]);
    return (grid_.lat_deg()[to] - grid_.lat_deg()[from]) /
           kg_core::LocalScale(middle_deg).lat_deg;
  }
  // Is a cell of row `to`, this far east or west of one of row `from`, within
  // `reach_m` of it? Eastward lengths at the scale of row `to`.
  bool Within(int from, int to, double lon_gap_deg, double reach_m) const {
    const double east_m = lon_gap_deg * m_per_lon_deg_[to];
    const double north_m = North_m(from, to);
    return east_m * east_m + north_m * north_m <= reach_m * reach_m;
  }
  Columns RowsWithin(int row, double reach_m) const {
    Columns rows{row, row + 1};
    while (rows.first > 0 && -North_m(row, rows.first - 1) <= reach_m) {
      --rows.first;
    }
    while (rows.last < grid_.rows() && North_m(row, rows.last) <= reach_m) {
      ++rows.last;
    }
    return rows;
  }
  // The cells that AddRow sums for a cell, but for those worth nothing.
  std::vector<int> Footprint(kg_core::Cell cell) const {
    std::vector<int> footprint;
    const Columns rows = RowsWithin(cell.row, radius_m_);
    for (int r = rows.first; r < rows.last; ++r) {
      const double north_m = North_m(cell.row, r);
      const double left_m2 = radius_m_ * radius_m_ - north_m * north_m;
      for (int c = 0; c < grid_.cols(); ++c) {
        const double east_m = LonGap(cell.col, c) * m_per_lon_deg_[r];
        const std::size_t i = grid_.Index({r, c});
        if (utility_[i] == 0 || !(east_m * east_m <= left_m2)) continue;
        footprint.push_back(static_cast<int>(i));
      }
    }
    return footprint;
  }
  std::int64_t* Sums(int row) {
    return &sums_[static_cast<std::size_t>(row) * (grid_.cols() + 1)];
  }
  void SumRow(int row) {
    std::int64_t* sums = Sums(row);
    const std::int64_t* utility = &utility_[grid_.Index({row, 0})];
    for (int c = 0; c < grid_.cols(); ++c) sums[c + 1] = sums[c] + utility[c];
  }
  Columns AllowedIn(int row) const {
    const auto begin = allowed_.begin() + grid_.Index({row, 0});
    const auto end = begin + grid_.cols();
    const auto first = std::find(begin, end, 1);
    if (first == end) return {};
    auto last = end;
    while (*(last - 1) != 1) --last;
    return {static_cast<int>(first - begin), static_cast<int>(last - begin)};
  }
  // R of a row's allowed cells, and the best of them.
  void Respond(int row) {
    best_[row] = {};
    const Columns allowed = AllowedIn(row);
    if (allowed.first == allowed.last) return;
    std::int64_t* response = &response_[grid_.Index({row, 0})];
    std::fill(response + allowed.first, response + allowed.last, 0);
    const Columns rows = RowsWithin(row, radius_m_);
    for (int r = rows.first; r < rows.last; ++r) {
      AddRow(row, r, allowed, response);
    }
    for (int c = allowed.first; c < allowed.last; ++c) {
      if (!allowed_[grid_.Index({row, c})]) continue;
      if (response[c] > best_[row].response) best_[row] = {response[c], c};
    }
  }
  // Adds what the discs around `row`'s cells see of row `r`: the columns within
  // sqrt(radius^2 - north^2) / scale on either side.
  void AddRow(int row, int r, Columns allowed, std::int64_t* response) {
    const double north_m = North_m(row, r);
    const double left_m2 = radius_m_ * radius_m_ - north_m * north_m;
    const double scale = m_per_lon_deg_[r];
    const std::vector<double>& lon = grid_.lon_deg();
    const auto sees = [&](int from, int to) {
      const double east_m = std::abs(lon[to] - lon[from]) * scale;
      return east_m * east_m <= left_m2;
    };
    const std::int64_t* sums = Sums(r);
    int low = 0, high = 0;  // Columns seen: [low, high).
    for (int c = allowed.first; c < allowed.last; ++c) {
      while (low < c && !sees(c, low)) ++low;
      high = std::max(high, c);
      while (high < grid_.cols() && sees(c, high)) ++high;
      response[c] += sums[high] - sums[low];
    }
  }

  const kg_core::Grid& grid_;
  kg_core::Mask allowed_;
  double radius_m_;
  double unit_ = 1.0;
  std::vector<double> m_per_lon_deg_;   // By row.
  std::vector<std::int64_t> utility_;   // In units.
  std::vector<std::int64_t> sums_;      // Row by row, prefix sums of utility.
  std::vector<std::int64_t> response_;  // R, of allowed cells.
  std::vector<RowBest> best_;
};

}  // namespace

std::vector<Pick> ProximalRecurrence(const kg_core::Grid& grid,
                                     const kg_core::Raster& utility,
                                     const kg_core::Mask& allowed,
                                     const RecurrenceOptions& options) {
  if (utility.size() != grid.size() || allowed.size() != grid.size()) {
    throw std::logic_error("utility and allowed are not of the grid's size");
  }
  std::vector<Pick> picks;
  if (options.count <= 0) return picks;
  Recurrence recurrence(grid, utility, allowed, options.radius_m);
  while (static_cast<int>(picks.size()) < options.count) {
    const std::optional<Pick> best = recurrence.Best();
    if (!best) break;
    picks.push_back(*best);
    recurrence.Blank(best->cell, options.spacing_m);
  }
  return picks;
}

Pick DiscSum(const kg_core::Grid& grid, const kg_core::Raster& utility,
             kg_core::Cell cell, double radius_m) {
  const kg_core::LonLat centre = grid.Centre(cell);
  Pick pick{cell, 0.0, {}};
  for (int r = 0; r < grid.rows(); ++r) {
    const double lat_deg = grid.lat_deg()[r];
    const double middle_deg = 0.5 * (lat_deg + centre.lat_deg);
    const double north_m =
        (lat_deg - centre.lat_deg) / kg_core::LocalScale(middle_deg).lat_deg;
    if (!(std::abs(north_m) <= radius_m)) continue;
    const double m_per_deg = 1.0 / kg_core::LocalScale(lat_deg).lon_deg;
    for (int c = 0; c < grid.cols(); ++c) {
      const std::size_t i = grid.Index({r, c});
      const double east_m = (grid.lon_deg()[c] - centre.lon_deg) * m_per_deg;
      const double square_m2 = east_m * east_m + north_m * north_m;
      if (!(square_m2 <= radius_m * radius_m) || utility[i] == 0.0f) continue;
      pick.score += utility[i];
      pick.footprint.push_back(static_cast<int>(i));
    }
  }
  return pick;
}

}  // namespace kg_compiler
