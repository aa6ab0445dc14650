#include "kg_compiler/control_plane/proximal_recurrence.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "kg_compiler/control_plane/disc.h"
#include "kg_compiler/control_plane/disc_sums.h"

namespace kg_compiler {
namespace {

constexpr int kStrip = DiscSums::kStrip;
constexpr int kGroup = DiscSums::kGroup;

// Range from the first to the last allowed column of `cols` in a row.
Span AllowedIn(const kg_base::Mask& allowed, const kg_base::Grid& grid, int row,
               Span cols) {
  const unsigned char* begin = allowed.data() + grid.Index({row, cols.first});
  const void* first = std::memchr(begin, 1, cols.size());
  if (!first) return {};
  int last = cols.size();
  while (begin[last - 1] != 1) --last;
  return {cols.first + static_cast<int>(
                           static_cast<const unsigned char*>(first) - begin),
          cols.first + last};
}

struct Box {
  Span rows;
  Span cols;
};

// Bounding box of the allowed cells.
Box AllowedBox(const kg_base::Grid& grid, const kg_base::Mask& allowed) {
  Box box{{}, {grid.cols(), 0}};
  for (int row = 0; row < grid.rows(); ++row) {
    const Span cols = AllowedIn(allowed, grid, row, {0, grid.cols()});
    if (cols.empty()) continue;
    if (box.rows.empty()) box.rows.first = row;
    box.rows.last = row + 1;
    box.cols = {std::min(box.cols.first, cols.first),
                std::max(box.cols.last, cols.last)};
  }
  return box;
}

class Recurrence {
 public:
  Recurrence(const kg_base::Grid& grid, const kg_base::Raster& utility,
             const kg_base::Mask& allowed, const Box& box,
             const RecurrenceOptions& options)
      : box_(box),
        sums_(grid, utility, options.radius_m, box.rows, box.cols),
        blanks_(grid, options.spacing_m, box.rows),
        strips_((box.cols.size() + kStrip - 1) / kStrip),
        groups_((box.cols.size() + kGroup - 1) / kGroup),
        extents_(static_cast<std::size_t>(box.rows.size()) * strips_),
        group_best_(static_cast<std::size_t>(box.rows.size()) * groups_),
        row_best_(box.rows.size()) {
    allowed_.reserve(static_cast<std::size_t>(box.rows.size()) *
                     box.cols.size());
    // Copy the allowed cells of the box row by row, and record per strip the
    // range of columns that contains them.
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      const auto from = allowed.begin() + grid.Index({row, box.cols.first});
      allowed_.insert(allowed_.end(), from,
                      from + static_cast<int>(box.cols.size()));
      for (int strip = 0; strip < strips_; ++strip) {
        Extent(row, strip) = AllowedIn(allowed, grid, row, StripCols(strip));
      }
    }
    Respond(box);
  }

  // The best allowed cell; ties go to the first.
  std::optional<RecurrencePick> Best() {
    const auto best = std::max_element(row_best_.begin(), row_best_.end());
    if (*best == 0) return std::nullopt;
    const int row =
        box_.rows.first + static_cast<int>(best - row_best_.begin());
    const kg_base::Cell cell{row, ColumnOf(row, *best)};
    return RecurrencePick{cell, static_cast<double>(*best) * sums_.unit(),
                          sums_.Footprint(cell)};
  }

  // Zeroes the disc around a pick and excludes it from later picks.
  void Blank(kg_base::Cell pick) {
    const Span rows = blanks_.Rows(pick.row);
    Span widest{pick.col, pick.col + 1};
    for (int row = rows.first; row < rows.last; ++row) {
      const Span cols = blanks_.Columns(pick, row);
      widest = {std::min(widest.first, cols.first),
                std::max(widest.last, cols.last)};
      sums_.Clear(row, cols);
      const Span here = Common(cols, box_.cols);
      if (box_.rows.Has(row) && !here.empty()) {
        std::fill_n(Allowed(row, here.first), here.size(), 0);
      }
    }
    const Span cols = sums_.ColumnsThatSee(widest);
    if (!cols.empty()) Respond({sums_.RowsThatSee(rows), WholeGroups(cols)});
  }

 private:
  std::size_t RowOf(int row) const { return row - box_.rows.first; }
  unsigned char* Allowed(int row, int col) {
    return &allowed_[RowOf(row) * box_.cols.size() + (col - box_.cols.first)];
  }
  Span& Extent(int row, int strip) {
    return extents_[RowOf(row) * strips_ + strip];
  }
  std::int64_t* GroupBest(int row) {
    return &group_best_[RowOf(row) * groups_];
  }
  Span StripCols(int strip) const {
    const int first = box_.cols.first + strip * kStrip;
    return {first, std::min(first + kStrip, box_.cols.last)};
  }
  Span WholeGroups(Span cols) const {
    const int west = (cols.first - box_.cols.first) / kGroup;
    const int east = (cols.last - 1 - box_.cols.first) / kGroup + 1;
    return {box_.cols.first + west * kGroup,
            std::min(box_.cols.first + east * kGroup, box_.cols.last)};
  }

  // Computes R for the allowed cells of a box of whole groups, and updates the
  // maxima of its rows.
  void Respond(const Box& box) {
    if (box.rows.empty()) return;
    const int last = (box.cols.last - 1 - box_.cols.first) / kStrip;
    for (int strip = (box.cols.first - box_.cols.first) / kStrip; strip <= last;
         ++strip) {
      RespondStrip(box, strip);
    }
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      const std::int64_t* best = GroupBest(row);
      row_best_[RowOf(row)] = *std::max_element(best, best + groups_);
    }
  }
  void RespondStrip(const Box& box, int strip) {
    Span wanted{box.cols.last, box.cols.first};
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      const Span cols = Common(box.cols, Extent(row, strip));
      if (cols.empty()) continue;
      wanted = {std::min(wanted.first, cols.first),
                std::max(wanted.last, cols.last)};
    }
    if (wanted.empty()) return;
    sums_.BeginStrip(WholeGroups(wanted));
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      const Span cols = Common(box.cols, Extent(row, strip));
      if (!cols.empty()) RespondRow(row, WholeGroups(cols));
    }
  }
  void RespondRow(int row, Span cols) {
    std::int64_t sums[kStrip + kGroup];
    sums_.Sum(row, cols, sums);
    const unsigned char* allowed = Allowed(row, cols.first);
    std::int64_t* best =
        GroupBest(row) + (cols.first - box_.cols.first) / kGroup;
    for (int first = 0; first < cols.size(); first += kGroup) {
      const int count = std::min(kGroup, cols.size() - first);
      *best++ = Largest(sums + first, allowed + first, count);
    }
  }
  static std::int64_t Largest(const std::int64_t* sums,
                              const unsigned char* allowed, int count) {
    std::int64_t most = 0;
    for (int i = 0; i < count; ++i) {
      most = std::max(most, allowed[i] == 1 ? sums[i] : 0);
    }
    return most;
  }
  // The first column of a row where R equals `response`, the row's maximum.
  int ColumnOf(int row, std::int64_t response) {
    const std::int64_t* best = GroupBest(row);
    const auto group = std::find(best, best + groups_, response) - best;
    const int first = box_.cols.first + static_cast<int>(group) * kGroup;
    const Span cols = WholeGroups({first, first + 1});
    std::int64_t sums[kGroup];
    sums_.BeginStrip(cols);
    sums_.Sum(row, cols, sums);
    const unsigned char* allowed = Allowed(row, first);
    for (int i = 0; i < cols.size(); ++i) {
      if (allowed[i] == 1 && sums[i] == response) return first + i;
    }
    throw std::logic_error("no column has its row's best response");
  }

  Box box_;  // Bounding box of the initially allowed cells.
  DiscSums sums_;
  Discs blanks_;
  int strips_;
  int groups_;
  kg_base::Mask allowed_;      // Cells of box_ still allowed.
  std::vector<Span> extents_;  // Initially allowed, by row and strip.
  std::vector<std::int64_t> group_best_;  // Largest R by row and group.
  std::vector<std::int64_t> row_best_;
};

}  // namespace

std::vector<RecurrencePick> ProximalRecurrence(
    const kg_base::Grid& grid, const kg_base::Raster& utility,
    const kg_base::Mask& allowed, const RecurrenceOptions& options) {
  if (utility.size() != grid.size() || allowed.size() != grid.size()) {
    throw std::logic_error("utility and allowed are not of the grid's size");
  }
  std::vector<RecurrencePick> picks;
  const Box box = AllowedBox(grid, allowed);
  if (options.count <= 0 || box.rows.empty()) return picks;
  Recurrence recurrence(grid, utility, allowed, box, options);
  while (static_cast<int>(picks.size()) < options.count) {
    std::optional<RecurrencePick> best = recurrence.Best();
    if (!best) break;
    recurrence.Blank(best->cell);
    picks.push_back(std::move(*best));
  }
  return picks;
}

RecurrencePick DiscSum(const kg_base::Grid& grid,
                       const kg_base::Raster& utility, kg_base::Cell cell,
                       double radius_m) {
  const Discs discs(grid, radius_m, {cell.row, cell.row + 1});
  RecurrencePick pick{cell, 0.0, {}};
  const Span rows = discs.Rows(cell.row);
  for (int row = rows.first; row < rows.last; ++row) {
    const Span cols = discs.Columns(cell, row);
    for (int col = cols.first; col < cols.last; ++col) {
      const std::size_t i = grid.Index({row, col});
      if (utility[i] == 0.0f) continue;
      pick.score += utility[i];
      pick.footprint.push_back(static_cast<int>(i));
    }
  }
  return pick;
}

}  // namespace kg_compiler
