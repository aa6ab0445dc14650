#include "kg_compiler/data_plane/blended_field.h"

#include <algorithm>

namespace kg_compiler {
namespace {

// Fields from this size on bypass the caches (non-temporal stores): they are
// not read again soon and would displace data that is.
constexpr std::size_t kStreamFrom_bytes = std::size_t{16} << 20;

struct RowSegment {
  kg_base::Cell first;
  int n = 0;
};

// Overlap of a row of a box with a segment.
struct ColumnOverlap {
  int begin = 0;  // Columns within the segment.
  int end = 0;
  int from = 0;  // First column within the box's row.
  bool empty() const { return begin >= end; }
};

ColumnOverlap Meet(const CellBox& box, kg_base::Cell first, int n) {
  if (!box.HasRow(first.row)) return {};
  const int begin = std::max(box.col - first.col, 0);
  const int end = std::min(box.col_end - first.col, n);
  return {begin, end, first.col + begin - box.col};
}

// Accumulators for segments with more than one prior or zone.
struct SegmentSums {
  float p[kTileCols];
  float s[kTileCols];
};

// The only item that overlaps the segment, if it covers all of it; otherwise
// null. `count` receives the number of overlapping items.
template <typename T>
const T* OnlyCover(const std::vector<T>& items, const RowSegment& at,
                   int* count) {
  const T* only = nullptr;
  *count = 0;
  for (const T& item : items) {
    const ColumnOverlap part = Meet(item.patch->box, at.first, at.n);
    if (part.empty()) continue;
    ++*count;
    only = part.end - part.begin == at.n ? &item : nullptr;
  }
  return *count == 1 ? only : nullptr;
}

void SetPriors(const BlendRecipe& recipe, const RowSegment& at,
               SegmentSums* sums, PassRow* row) {
  int count = 0;
  const WeightedPatch* only = OnlyCover(recipe.priors, at, &count);
  if (count == 0) return;
  if (only) {
    row->priors =
        only->patch->Row(at.first.row) + (at.first.col - only->patch->box.col);
    row->weight = only->weight;
    return;
  }
  PriorsOfRow(recipe, at.first, at.n, sums->p);
  row->priors = sums->p;
  row->weight = 1.0f;
}

void SetSoftness(const BlendRecipe& recipe, const RowSegment& at,
                 SegmentSums* sums, PassRow* row) {
  int count = 0;
  const SoftZone* only = OnlyCover(recipe.soft, at, &count);
  if (count == 0) return;
  if (only) {
    row->inside =
        only->patch->Row(at.first.row) + (at.first.col - only->patch->box.col);
    row->factor = only->factor;
    return;
  }
  SoftnessOfRow(recipe, at.first, at.n, sums->s);
  row->softness = sums->s;
}

bool IsStreamed(const BlendedField& field) {
  return static_cast<std::size_t>(field.tiling.rows) * field.tiling.cols *
             sizeof(float) >=
         kStreamFrom_bytes;
}

constexpr float kNoLayer[kTileCols] = {};

// Writes V' to `y`; returns the extremes of the segment's open cells.
ValueExtremes ComputeSegment(const WindowRasters& rasters,
                             const BlendedField& field, const RowSegment& at,
                             float* y) {
  SegmentSums sums;
  PassRow row;
  SetPriors(field.recipe, at, &sums, &row);
  SetSoftness(field.recipe, at, &sums, &row);
  row.state = field.state.Row(at.first.row) + at.first.col;
  row.is_far = IsStreamed(field);
  if (field.table) {
    return field.table->Pass(rasters.value, field.recipe.weights, at.first,
                             at.n, row, y);
  }
  row.values = kNoLayer;
  return PassBase(row, at.n, y);
}

}  // namespace

ValueExtremes BlendedField::All() const {
  ValueExtremes all;
  for (const ValueExtremes& tile : extremes) all = Both(all, tile);
  return all;
}

void PriorsOfRow(const BlendRecipe& recipe, kg_base::Cell first, int n,
                 float* p) {
  std::fill(p, p + n, 0.0f);
  for (const WeightedPatch& prior : recipe.priors) {
    const ColumnOverlap part = Meet(prior.patch->box, first, n);
    if (part.empty()) continue;
    AddWeighted(prior.patch->Row(first.row) + part.from, prior.weight,
                part.end - part.begin, p + part.begin);
  }
}

bool SoftnessOfRow(const BlendRecipe& recipe, kg_base::Cell first, int n,
                   float* s) {
  bool any = false;
  for (const SoftZone& zone : recipe.soft) {
    const ColumnOverlap part = Meet(zone.patch->box, first, n);
    if (part.empty()) continue;
    if (!any) std::fill(s, s + n, 1.0f);
    any = true;
    const unsigned char* inside = zone.patch->Row(first.row) + part.from;
    const bool product = recipe.overlap == kg_mission::SoftOverlap::kProduct;
    (product ? Attenuate : AttenuateToLeast)(
        inside, zone.factor, part.end - part.begin, s + part.begin);
  }
  return any;
}

void CloseCells(const kg_base::Mask& land, const BlendRecipe& recipe,
                const CellBox& box, RowBands<unsigned char>* state) {
  for (int r = box.row; r < box.row_end; ++r) {
    const unsigned char* dry =
        &land[static_cast<std::size_t>(r) * state->cols()];
    unsigned char* row = state->RowToWrite(r);
    for (int c = box.col; c < box.col_end; ++c) row[c] = dry[c] ? kLand : kOpen;
    for (const HardZone& zone : recipe.hard) {
      const ColumnOverlap part =
          Meet(zone.patch->box, {r, box.col}, box.cols());
      if (part.empty()) continue;
      const unsigned char* inside = zone.patch->Row(r) + part.from;
      unsigned char* cells = row + box.col + part.begin;
      for (int c = 0; c < part.end - part.begin; ++c) {
        const bool closes = inside[c] && cells[c] == kOpen;
        cells[c] = closes ? static_cast<unsigned char>(kClosed) : cells[c];
      }
    }
  }
}

void ComputeRows(const WindowRasters& rasters, int row, int row_end,
                 BlendedField* field) {
  const TileLayout& tiling = field->tiling;
  const bool is_streamed = IsStreamed(*field);
  const int width = tiling.width;
  for (int r = row; r < row_end; ++r) {
    float* to = field->masked.RowToWrite(r);
    for (int t = 0; t < tiling.across; ++t) {
      const int col = t * width;
      const RowSegment at{{r, col}, std::min(width, tiling.cols - col)};
      // A large field is computed in a cached buffer, then streamed to memory.
      alignas(kRowAlignment) float y[kTileCols];
      float* made = is_streamed ? y : to + col;
      const ValueExtremes found = ComputeSegment(rasters, *field, at, made);
      if (is_streamed) Stream(y, at.n, to + col);
      ValueExtremes& tile =
          field->extremes[RowBands<float>::BandOf(r) * tiling.across + t];
      // The first row of a band resets its tiles' extremes.
      tile = r % kBandRows == 0 ? found : Both(tile, found);
    }
  }
  if (is_streamed) StreamEnd();
}

void ComputeBox(const WindowRasters& rasters, const CellBox& box,
                BlendedField* field) {
  const int width = field->tiling.width;
  for (int r = box.row; r < box.row_end; ++r) {
    float* to = field->masked.RowToWrite(r);
    for (int col = box.col; col < box.col_end;) {
      const int tile_end = (col / width + 1) * width;
      const RowSegment at{{r, col}, std::min(tile_end, box.col_end) - col};
      ComputeSegment(rasters, *field, at, to + col);
      col += at.n;
    }
  }
}

void MeasureTiles(const CellBox& box, BlendedField* field) {
  const TileLayout& tiling = field->tiling;
  if (box.empty()) return;
  const int width = tiling.width;
  const int first_band = RowBands<float>::BandOf(box.row);
  const int last_band = RowBands<float>::BandOf(box.row_end - 1);
  for (int band = first_band; band <= last_band; ++band) {
    for (int t = box.col / width; t <= (box.col_end - 1) / width; ++t) {
      const int i = band * tiling.across + t;
      // Rescan the whole tile: an overwritten cell may have been its extreme.
      const CellBox tile = tiling.Box(i);
      field->extremes[i] = {};
      for (int r = tile.row; r < tile.row_end; ++r) {
        field->extremes[i] =
            Both(field->extremes[i],
                 OpenExtremes(field->masked.Row(r) + tile.col,
                              field->state.Row(r) + tile.col, tile.cols()));
      }
    }
  }
}

}  // namespace kg_compiler
