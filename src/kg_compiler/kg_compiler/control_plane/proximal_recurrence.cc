#include "kg_compiler/control_plane/proximal_recurrence.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>

#include "kg_compiler/control_plane/disc.h"
#include "kg_compiler/control_plane/disc_sums.h"

namespace kg_compiler {
namespace {

constexpr int kStrip = DiscSums::kStrip;
constexpr std::int64_t kForbidden = -1;  // In place of R.

// From the first to the last allowed column of `cols` in a row.
Span AllowedIn(const kg_core::Mask& allowed, const kg_core::Grid& grid, int row,
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

// The least box that holds all allowed cells.
Box AllowedBox(const kg_core::Grid& grid, const kg_core::Mask& allowed) {
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
  Recurrence(const kg_core::Grid& grid, const kg_core::Raster& utility,
             const kg_core::Mask& allowed, const Box& box,
             const RecurrenceOptions& options)
      : grid_(grid),
        box_(box),
        sums_(grid, utility, options.radius_m, box.rows, box.cols),
        blanks_(grid, options.spacing_m, box.rows),
        strips_((box.cols.size() + kStrip - 1) / kStrip),
        response_(new std::int64_t[static_cast<std::size_t>(box.rows.size()) *
                                   box.cols.size()]),
        segments_(static_cast<std::size_t>(box.rows.size()) * strips_),
        best_(box.rows.size()) {
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      for (int strip = 0; strip < strips_; ++strip) Forbid(row, strip, allowed);
    }
    Respond(box);
  }

  // The best allowed cell, the first of equals.
  std::optional<Pick> Best() const {
    const auto best = std::max_element(best_.begin(), best_.end());
    if (*best == 0) return std::nullopt;
    const int row = box_.rows.first + static_cast<int>(best - best_.begin());
    const kg_core::Cell cell{row, ColumnOf(row, *best)};
    return Pick{cell, static_cast<double>(*best) * sums_.unit(),
                sums_.Footprint(cell)};
  }

  // Blanks the disc around a pick and forbids it to later picks.
  void Blank(kg_core::Cell pick) {
    const Span rows = blanks_.Rows(pick.row);
    Span widest{pick.col, pick.col + 1};
    for (int row = rows.first; row < rows.last; ++row) {
      const Span cols = blanks_.Columns(pick, row);
      widest = {std::min(widest.first, cols.first),
                std::max(widest.last, cols.last)};
      sums_.Clear(row, cols);
      if (box_.rows.Has(row)) Forbid(row, cols);
    }
    Respond({sums_.RowsThatSee(rows), sums_.ColumnsThatSee(widest)});
  }

 private:
  struct Segment {          // A row's part in a strip.
    Span allowed;           // From the first to the last column once allowed.
    std::int64_t best = 0;  // The largest R.
  };

  std::size_t ResponseIndex(int row, int col) const {
    return static_cast<std::size_t>(row - box_.rows.first) * box_.cols.size() +
           (col - box_.cols.first);
  }
  std::int64_t* Response(int row, int col) {
    return &response_[ResponseIndex(row, col)];
  }
  const std::int64_t* Response(int row, int col) const {
    return &response_[ResponseIndex(row, col)];
  }
  std::size_t SegmentIndex(int row, int strip) const {
    return static_cast<std::size_t>(row - box_.rows.first) * strips_ + strip;
  }
  Segment& SegmentOf(int row, int strip) {
    return segments_[SegmentIndex(row, strip)];
  }
  const Segment& SegmentOf(int row, int strip) const {
    return segments_[SegmentIndex(row, strip)];
  }
  Span StripCols(int strip) const {
    const int first = box_.cols.first + strip * kStrip;
    return {first, std::min(first + kStrip, box_.cols.last)};
  }
  Span StripsOf(Span cols) const {
    return {(cols.first - box_.cols.first) / kStrip,
            (cols.last - 1 - box_.cols.first) / kStrip + 1};
  }

  // To begin with, cells that are not allowed.
  void Forbid(int row, int strip, const kg_core::Mask& allowed) {
    const Span cols = AllowedIn(allowed, grid_, row, StripCols(strip));
    SegmentOf(row, strip).allowed = cols;
    if (cols.empty()) return;
    const unsigned char* mask = &allowed[grid_.Index({row, cols.first})];
    std::int64_t* response = Response(row, cols.first);
    for (int i = 0; i < cols.size(); ++i) {
      response[i] = mask[i] == 1 ? 0 : kForbidden;
    }
  }
  void Forbid(int row, Span cols) {
    const Span here = Common(cols, box_.cols);
    if (here.empty()) return;
    const Span strips = StripsOf(here);
    for (int strip = strips.first; strip < strips.last; ++strip) {
      const Span gone = Common(here, SegmentOf(row, strip).allowed);
      if (gone.empty()) continue;
      std::fill_n(Response(row, gone.first), gone.size(), kForbidden);
    }
  }

  // R of the allowed cells of a box, and the best of its rows.
  void Respond(const Box& box) {
    if (box.rows.empty() || box.cols.empty()) return;
    const Span strips = StripsOf(box.cols);
    for (int strip = strips.first; strip < strips.last; ++strip) {
      RespondStrip(box, strip);
    }
    for (int row = box.rows.first; row < box.rows.last; ++row) ChooseBest(row);
  }
  void RespondStrip(const Box& box, int strip) {
    Span wanted{box.cols.last, box.cols.first};
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      const Span cols = Common(box.cols, SegmentOf(row, strip).allowed);
      if (cols.empty()) continue;
      wanted = {std::min(wanted.first, cols.first),
                std::max(wanted.last, cols.last)};
    }
    if (wanted.empty()) return;
    sums_.BeginStrip(wanted);
    for (int row = box.rows.first; row < box.rows.last; ++row) {
      Segment& segment = SegmentOf(row, strip);
      const Span cols = Common(box.cols, segment.allowed);
      if (!cols.empty()) RespondSegment(row, cols, &segment);
    }
  }
  void RespondSegment(int row, Span cols, Segment* segment) {
    std::int64_t sums[kStrip + DiscSums::kGroup];
    sums_.Sum(row, cols, sums);
    std::int64_t* response = Response(row, cols.first);
    for (int i = 0; i < cols.size(); ++i) {
      response[i] = sums[i] | response[i] >> 63;  // kForbidden stays.
    }
    segment->best =
        Largest(Response(row, segment->allowed.first), segment->allowed.size());
  }
  static std::int64_t Largest(const std::int64_t* response, int count) {
    std::int64_t most[4] = {};  // By turns: one would wait for itself.
    for (; count >= 4; count -= 4, response += 4) {
      for (int i = 0; i < 4; ++i) most[i] = std::max(most[i], response[i]);
    }
    for (int i = 0; i < count; ++i) most[0] = std::max(most[0], response[i]);
    return *std::max_element(most, most + 4);
  }
  void ChooseBest(int row) {
    std::int64_t& best = best_[row - box_.rows.first];
    best = 0;
    for (int strip = 0; strip < strips_; ++strip) {
      best = std::max(best, SegmentOf(row, strip).best);
    }
  }
  // The first column of a row that has this response.
  int ColumnOf(int row, std::int64_t response) const {
    for (int strip = 0; strip < strips_; ++strip) {
      const Segment& segment = SegmentOf(row, strip);
      if (segment.best != response) continue;
      const std::int64_t* begin = Response(row, segment.allowed.first);
      const auto* at =
          std::find(begin, begin + segment.allowed.size(), response);
      return segment.allowed.first + static_cast<int>(at - begin);
    }
    throw std::logic_error("no column has the row's best response");
  }

  const kg_core::Grid& grid_;
  Box box_;  // Of the cells that were allowed.
  DiscSums sums_;
  Discs blanks_;
  int strips_;
  // R of the box's segments, or kForbidden; elsewhere never touched.
  std::unique_ptr<std::int64_t[]> response_;
  std::vector<Segment> segments_;   // By row and strip.
  std::vector<std::int64_t> best_;  // The largest R by row.
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
  const Box box = AllowedBox(grid, allowed);
  if (options.count <= 0 || box.rows.empty()) return picks;
  Recurrence recurrence(grid, utility, allowed, box, options);
  while (static_cast<int>(picks.size()) < options.count) {
    std::optional<Pick> best = recurrence.Best();
    if (!best) break;
    recurrence.Blank(best->cell);
    picks.push_back(std::move(*best));
  }
  return picks;
}

Pick DiscSum(const kg_core::Grid& grid, const kg_core::Raster& utility,
             kg_core::Cell cell, double radius_m) {
  const Discs discs(grid, radius_m, {cell.row, cell.row + 1});
  Pick pick{cell, 0.0, {}};
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
