#include "kg_compiler/control_plane/disc.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"

namespace kg_compiler {
namespace {

constexpr double kSlack = 1e-12;  // Relative rounding error of short sums.

}  // namespace

Span Common(Span a, Span b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

double MeridianArc_m(double lat_deg) {
  constexpr double kEquator_m = 6378137.0;
  constexpr double kFlattening = 1.0 / 298.257223563;
  constexpr double n = kFlattening / (2.0 - kFlattening);
  constexpr double n2 = n * n;
  const double lat = kg_base::DegToRad(lat_deg);
  return kEquator_m / (1.0 + n) *
         ((1.0 + n2 / 4.0 + n2 * n2 / 64.0) * lat -
          1.5 * n * (1.0 - n2 / 8.0) * std::sin(2.0 * lat) +
          15.0 / 16.0 * n2 * (1.0 - n2 / 4.0) * std::sin(4.0 * lat) -
          35.0 / 48.0 * n2 * n * std::sin(6.0 * lat) +
          315.0 / 512.0 * n2 * n2 * std::sin(8.0 * lat));
}

Discs::Discs(const kg_base::Grid& grid, double radius_m, Span rows)
    : grid_(grid), radius_m_(radius_m), known_(rows) {
  if (!(radius_m >= 0.0)) throw std::logic_error("a radius must be >= 0");
  const std::vector<double>& lat = grid.lat_deg();
  const double low_m = MeridianArc_m(lat[rows.first]) - radius_m;
  const double high_m = MeridianArc_m(lat[rows.last - 1]) + radius_m;
  while (known_.first > 0 && MeridianArc_m(lat[known_.first - 1]) >= low_m) {
    --known_.first;
  }
  while (known_.last < grid.rows() &&
         MeridianArc_m(lat[known_.last]) <= high_m) {
    ++known_.last;
  }
  for (int row = known_.first; row < known_.last; ++row) {
    north_m_.push_back(MeridianArc_m(lat[row]));
    m_per_lon_deg_.push_back(1.0 / kg_base::LocalScale(lat[row]).lon_deg);
  }
}

Discs::Chord Discs::ChordOf(int row, int other) const {
  const double north_m =
      north_m_[other - known_.first] - north_m_[row - known_.first];
  return {radius_m_ * radius_m_ - north_m * north_m,
          m_per_lon_deg_[other - known_.first]};
}

Span Discs::Rows(int row) const {
  Span rows{row, row + 1};
  while (rows.first > known_.first && ChordOf(row, rows.first - 1).Sees(0.0)) {
    --rows.first;
  }
  while (rows.last < known_.last && ChordOf(row, rows.last).Sees(0.0)) {
    ++rows.last;
  }
  return rows;
}

double Discs::Reach_deg(int row, int other) const {
  const Chord chord = ChordOf(row, other);
  return std::sqrt(std::max(0.0, chord.left_m2)) / chord.m_per_deg;
}

double Discs::WidestReach_deg() const {
  return radius_m_ * (1.0 + kSlack) /
         *std::min_element(m_per_lon_deg_.begin(), m_per_lon_deg_.end());
}

Span Discs::Columns(kg_base::Cell centre, int other) const {
  const std::vector<double>& lon = grid_.lon_deg();
  const Chord chord = ChordOf(centre.row, other);
  const double reach_deg = Reach_deg(centre.row, other);
  const double at_deg = lon[centre.col];
  const auto sees = [&](int col) {
    return chord.Sees(std::abs(lon[col] - at_deg));
  };
  const auto near = [&](double lon_deg) {
    return static_cast<int>(std::lower_bound(lon.begin(), lon.end(), lon_deg) -
                            lon.begin());
  };
  // Ends of the chord up to rounding, then corrected stepwise to the exact
  // ones.
  Span columns{near(at_deg - reach_deg), near(at_deg + reach_deg)};
  while (columns.first > 0 && sees(columns.first - 1)) --columns.first;
  while (columns.first < centre.col && !sees(columns.first)) ++columns.first;
  while (columns.last < grid_.cols() && sees(columns.last)) ++columns.last;
  while (columns.last > columns.first && !sees(columns.last - 1)) {
    --columns.last;
  }
  return columns;
}

void Discs::Columns(int row, Span centres, int other,
                    std::vector<Span>* out) const {
  const std::vector<double>& lon = grid_.lon_deg();
  const Chord chord = ChordOf(row, other);
  Span seen = Columns({row, centres.first}, other);
  out->clear();
  for (int col = centres.first; col < centres.last; ++col) {
    while (seen.first < col && !chord.Sees(lon[col] - lon[seen.first])) {
      ++seen.first;
    }
    seen.last = std::max(seen.last, col);
    while (seen.last < grid_.cols() && chord.Sees(lon[seen.last] - lon[col])) {
      ++seen.last;
    }
    out->push_back(seen);
  }
}

EvenColumns::EvenColumns(const kg_base::Grid& grid) : cols_(grid.cols()) {
  const std::vector<double>& lon = grid.lon_deg();
  step_deg_ = (lon.back() - lon.front()) / (cols_ - 1);
  double off_deg = 0.0;
  for (int col = 0; col < cols_; ++col) {
    off_deg =
        std::max(off_deg, std::abs(lon[col] - (lon.front() + col * step_deg_)));
  }
  slack_deg_ = 2.0 * off_deg + 360.0 * kSlack;
}

std::optional<int> EvenColumns::HalfWidth(double reach_deg) const {
  if (!(reach_deg < cols_ * step_deg_)) return cols_;
  const int width = static_cast<int>(reach_deg / step_deg_);
  const bool sure_of_last =
      width == 0 || width * step_deg_ + slack_deg_ <= reach_deg;
  const bool sure_of_next = (width + 1) * step_deg_ - slack_deg_ > reach_deg;
  if (!sure_of_last || !sure_of_next) return std::nullopt;
  return width;
}

}  // namespace kg_compiler
