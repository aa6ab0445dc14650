#include "kg_compiler/control_plane/disc_sums.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace kg_compiler {
namespace {

constexpr int kBits = 31;  // Sums of 2^32 cells fit in 63 bits.
constexpr int kUneven = -1;

// Columns within `gap_deg` of `cols`, plus one on either side as a margin for
// rounding.
Span Widened(const kg_base::Grid& grid, Span cols, double gap_deg) {
  const std::vector<double>& lon = grid.lon_deg();
  const auto west = std::lower_bound(lon.begin(), lon.begin() + cols.first,
                                     lon[cols.first] - gap_deg);
  const auto east = std::upper_bound(lon.begin() + cols.last, lon.end(),
                                     lon[cols.last - 1] + gap_deg);
  return {std::max(0, static_cast<int>(west - lon.begin()) - 1),
          std::min(grid.cols(), static_cast<int>(east - lon.begin()) + 1)};
}

using Run = DiscSums::Run;

// sums[i] = sum of east[i] - west[i] over the runs, one group at a time, so
// that the sums of a group stay in registers.
inline __attribute__((always_inline)) void AddGroups(
    const std::vector<Run>& runs, int count, std::int64_t* sums) {
  for (int first = 0; first < count; first += DiscSums::kGroup) {
    std::int64_t group[DiscSums::kGroup] = {};
    for (const Run& run : runs) {
      for (int i = 0; i < DiscSums::kGroup; ++i) {
        group[i] += run.east[first + i] - run.west[first + i];
      }
    }
    std::copy_n(group, DiscSums::kGroup, sums + first);
  }
}

// Rounds values to the nearest multiple of the unit; values not > 0 become 0.
// Results are below 2^31 and fit in int.
inline __attribute__((always_inline)) void RoundToUnits(const float* values,
                                                        int count,
                                                        double per_unit,
                                                        std::int32_t* units) {
  for (int i = 0; i < count; ++i) {
    const float value = values[i] > 0.0f ? values[i] : 0.0f;
    units[i] = static_cast<std::int32_t>(value * per_unit + 0.5);
  }
}

#if defined(__x86_64__)
// As AddGroups in wider registers; integer sums, so results are identical.
__attribute__((target("avx2"))) void AddGroupsAvx2(const std::vector<Run>& runs,
                                                   int count,
                                                   std::int64_t* sums) {
  AddGroups(runs, count, sums);
}
__attribute__((target("avx2"))) void RoundToUnitsAvx2(const float* values,
                                                      int count,
                                                      double per_unit,
                                                      std::int32_t* units) {
  RoundToUnits(values, count, per_unit, units);
}
const bool kHasAvx2 = __builtin_cpu_supports("avx2");
const auto add_runs = kHasAvx2 ? AddGroupsAvx2 : AddGroups;
const auto round_to_units = kHasAvx2 ? RoundToUnitsAvx2 : RoundToUnits;
#else
const auto add_runs = AddGroups;
const auto round_to_units = RoundToUnits;
#endif

}  // namespace

DiscSums::DiscSums(const kg_base::Grid& grid, const kg_base::Raster& values,
                   double radius_m, Span rows, Span cols)
    : grid_(grid),
      discs_(grid, radius_m, rows),
      centre_rows_(rows),
      centre_cols_(cols),
      cols_(Widened(grid, cols, discs_.WidestReach_deg())),
      values_(values),
      cleared_(discs_.rows().size()) {
  int exponent = 0;
  std::frexp(Largest(), &exponent);
  unit_ = std::ldexp(1.0, exponent - kBits);
  per_unit_ = std::ldexp(1.0, kBits - exponent);
  MeasureDiscs(rows);
}

// Compares bit patterns as integers, which is faster and preserves the order of
// floats >= 0.
float DiscSums::Largest() const {
  constexpr std::int32_t kInfinity = 0x7f800000;
  std::int32_t most = 0;
  for (int row = rows().first; row < rows().last; ++row) {
    const float* in = &values_[grid_.Index({row, cols_.first})];
    for (int i = 0; i < cols_.size(); ++i) {
      std::int32_t bits;
      std::memcpy(&bits, in + i, sizeof bits);
      bits = bits < kInfinity ? bits : 0;
      most = bits > most ? bits : most;
    }
  }
  float largest;
  std::memcpy(&largest, &most, sizeof largest);
  return largest;
}

void DiscSums::Units(int row, Span cols, std::int32_t* units) const {
  round_to_units(&values_[grid_.Index({row, cols.first})], cols.size(),
                 per_unit_, units);
  for (const Span& cleared : cleared_[row - rows().first]) {
    const Span gone = Common(cleared, cols);
    if (gone.empty()) continue;
    std::fill_n(units + (gone.first - cols.first), gone.size(), 0);
  }
}

void DiscSums::MeasureDiscs(Span rows) {
  const EvenColumns columns(grid_);
  for (int row = rows.first; row < rows.last; ++row) {
    const Span disc = discs_.Rows(row);
    disc_rows_.push_back(disc);
    first_width_.push_back(widths_.size());
    most_rows_ = std::max(most_rows_, disc.size());
    for (int other = disc.first; other < disc.last; ++other) {
      widths_.push_back(
          columns.HalfWidth(discs_.Reach_deg(row, other)).value_or(kUneven));
      widest_ = std::max(widest_, widths_.back());
    }
  }
}

Span DiscSums::RowsThatSee(Span rows) const {
  const auto sees_first = [&](const Span& disc) {
    return disc.last <= rows.first;
  };
  const auto begin =
      std::partition_point(disc_rows_.begin(), disc_rows_.end(), sees_first);
  const auto end = std::partition_point(
      begin, disc_rows_.end(),
      [&](const Span& disc) { return disc.first < rows.last; });
  return {centre_rows_.first + static_cast<int>(begin - disc_rows_.begin()),
          centre_rows_.first + static_cast<int>(end - disc_rows_.begin())};
}

Span DiscSums::ColumnsThatSee(Span cols) const {
  if (cols.empty()) return {};
  return Common(Widened(grid_, cols, discs_.WidestReach_deg()), centre_cols_);
}

void DiscSums::Clear(int row, Span cols) {
  if (rows().Has(row)) cleared_[row - rows().first].push_back(cols);
}

// The strip covers all columns seen from the centres, half widths that extend
// beyond the grid, and the surplus of the last group.
void DiscSums::BeginStrip(Span cols) {
  const Span seen = Widened(grid_, cols, discs_.WidestReach_deg());
  strip_ = {std::min(seen.first, cols.first - widest_),
            std::max(seen.last, cols.last + widest_) + kGroup};
  prefix_size_ = static_cast<std::size_t>(strip_.size()) + 1;
  prefixes_.resize(prefix_size_ * most_rows_);
  prefix_row_.assign(most_rows_, -1);
  units_.resize(prefix_size_);
}

const std::int64_t* DiscSums::Prefix(int row) {
  const std::size_t slot = row % most_rows_;
  std::int64_t* prefix = &prefixes_[slot * prefix_size_];
  if (prefix_row_[slot] == row) return prefix;
  prefix_row_[slot] = row;
  const Span known = Common(strip_, cols_);
  Units(row, known, units_.data());
  std::int64_t* at = std::fill_n(prefix, known.first - strip_.first + 1, 0);
  std::int64_t sum = 0;
  for (int i = 0; i < known.size(); ++i) at[i] = sum += units_[i];
  std::fill(at + known.size(), prefix + prefix_size_, sum);
  return prefix;
}

void DiscSums::Sum(int row, Span cols, std::int64_t* sums) {
  const std::size_t index = row - centre_rows_.first;
  const Span disc = disc_rows_[index];
  const int* widths = &widths_[first_width_[index]];
  const int from = cols.first - strip_.first;
  runs_.clear();
  for (int other = disc.first; other < disc.last; ++other) {
    const int width = widths[other - disc.first];
    if (width == kUneven) continue;
    const std::int64_t* prefix = Prefix(other) + from;
    const Run run{prefix - width, prefix + width + 1};
    if (run.east[cols.size() - 1] != run.west[0]) runs_.push_back(run);
  }
  add_runs(runs_, cols.size(), sums);
  for (int other = disc.first; other < disc.last; ++other) {
    if (widths[other - disc.first] != kUneven) continue;
    AddUneven(row, cols, other, sums);
  }
}

void DiscSums::AddUneven(int row, Span cols, int other, std::int64_t* sums) {
  const std::int64_t* prefix = Prefix(other);
  discs_.Columns(row, cols, other, &uneven_);
  for (int i = 0; i < cols.size(); ++i) {
    sums[i] += prefix[uneven_[i].last - strip_.first] -
               prefix[uneven_[i].first - strip_.first];
  }
}

std::vector<int> DiscSums::Footprint(kg_base::Cell centre) const {
  std::vector<int> footprint;
  std::vector<std::int32_t> units(cols_.size());
  const Span disc = disc_rows_[centre.row - centre_rows_.first];
  for (int row = disc.first; row < disc.last; ++row) {
    const Span seen = discs_.Columns(centre, row);
    Units(row, seen, units.data());
    for (int col = seen.first; col < seen.last; ++col) {
      if (units[col - seen.first] == 0) continue;
      footprint.push_back(static_cast<int>(grid_.Index({row, col})));
    }
  }
  return footprint;
}

}  // namespace kg_compiler
