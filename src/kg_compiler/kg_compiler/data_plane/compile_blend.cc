#include "kg_compiler/data_plane/compile_blend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/parallel.h"
#include "kg_compiler/data_plane/blend.h"

namespace kg_compiler {
namespace {

using kg_mission::Policy;

// Magnitudes for which float32 products and sums of squares neither overflow
// nor lose digits.
constexpr float kSmallest = 1e-30f;
constexpr float kLargest = 1e30f;

// Below this size starting threads costs more than it saves.
constexpr std::size_t kThreadsFrom_cells = 2'000'000;

bool IsComfortable(float x) {
  return x == 0.0f || (std::abs(x) >= kSmallest && std::abs(x) <= kLargest);
}

class BlendCompiler {
 public:
  BlendCompiler(const TensorInputs& inputs, const ActiveFacts& active,
                const std::shared_ptr<const BlendedField>& previous)
      : in_(inputs),
        active_(active),
        policy_(inputs.agent->policy),
        rasters_(*inputs.rasters),
        previous_(previous) {}

  MadeBlend Make() {
    field_->recipe =
        WriteRecipe(*in_.mission, policy_, active_, rasters_,
                    previous_ ? &previous_->recipe : nullptr, in_.cache);
    field_->tiling = TileLayout(rasters_.grid.rows(), rasters_.grid.cols());
    has_same_sea_ =
        previous_ && previous_->recipe.land_hash == field_->recipe.land_hash;
    if (policy_.paper_literal) return Slowly();
    FindTable();
    MakeState();
    if (!SetWeights()) return Slowly();
    return CanUpdate() ? Update() : Whole();
  }

 private:
  void FindTable() {
    if (!active_.reads_value) return;
    if (has_same_sea_ && previous_->table &&
        previous_->recipe.content_hash == field_->recipe.content_hash) {
      field_->table = previous_->table;
      return;
    }
    const auto make = [&] {
      return std::make_shared<const LayerTable>(rasters_.grid, rasters_.value);
    };
    field_->table = in_.cache
                        ? in_.cache->Table(field_->recipe.content_hash, make)
                        : make();
  }

  void MakeState() {
    if (has_same_sea_) {
      hard_changes_ = HardChanges(previous_->recipe, field_->recipe);
      field_->state = previous_->state;
      for (const CellBox& box : hard_changes_) {
        field_->state.Renew(box.row, box.row_end);
        CloseCells(rasters_.land, field_->recipe, box, &field_->state);
      }
      return;
    }
    field_->state =
        RowBands<unsigned char>(field_->tiling.rows, field_->tiling.cols);
    ForEachBand([&](int row, int row_end) {
      CloseCells(rasters_.land, field_->recipe,
                 {row, row_end, 0, field_->tiling.cols}, &field_->state);
    });
  }

  // False if some number is outside the safe range of float32.
  bool SetWeights() {
    LayerTable::Weights& weights = field_->recipe.weights;
    weights.op = policy_.front_operator;
    if (field_->table) {
      if (!IsComfortable(field_->table->max_abs())) return false;
      if (policy_.alpha_base != 0.0) {
        weights.base = static_cast<float>(policy_.alpha_base / ValueScale());
      }
      if (policy_.gamma_front != 0.0) {
        weights.front = static_cast<float>(policy_.gamma_front / FrontScale());
      }
    }
    bool fits = IsComfortable(weights.base) && IsComfortable(weights.front);
    for (const WeightedPatch& prior : field_->recipe.priors) {
      fits = fits && IsComfortable(prior.weight);
    }
    return fits;
  }

  // Divisors of B and F; infinite where the layer is to be 0.
  double ValueScale() const {
    const double max_value =
        policy_.layer_scale == kg_mission::LayerScale::kWindow
            ? field_->table->MaxOpenValue(rasters_.value, field_->state)
            : 0.0;
    return LayerDivisor(policy_, rasters_.full_scale, max_value);
  }
  double FrontScale() const {
    const double max_value =
        policy_.layer_scale == kg_mission::LayerScale::kWindow
            ? field_->table->MaxOpenFront(rasters_.value,
                                          policy_.front_operator, field_->state)
            : 0.0;
    return LayerDivisor(policy_, rasters_.front_full_scale, max_value);
  }

  bool CanUpdate() {
    if (!has_same_sea_ || previous_->is_literal || previous_->unit != 1.0) {
      return false;
    }
    const BlendRecipe& old = previous_->recipe;
    const BlendRecipe& now = field_->recipe;
    const bool has_same_layers = old.content_hash == now.content_hash &&
                                 old.overlap == now.overlap &&
                                 old.weights.base == now.weights.base &&
                                 old.weights.front == now.weights.front &&
                                 old.weights.op == now.weights.op;
    if (!has_same_layers) return false;
    changes_ = SoftChanges(old, now);
    const std::vector<CellBox> priors = PriorChanges(old, now);
    changes_.insert(changes_.end(), priors.begin(), priors.end());
    return Cells() < rasters_.grid.size();
  }

  std::size_t Cells() const {
    std::size_t cells = 0;
    for (const CellBox& box : changes_) cells += box.size();
    for (const CellBox& box : hard_changes_) cells += box.size();
    return cells;
  }

  MadeBlend Update() {
    if (Cells() == 0) return {previous_, 0};
    field_->masked = previous_->masked;
    field_->extremes = previous_->extremes;
    for (const CellBox& box : changes_) {
      field_->masked.Renew(box.row, box.row_end);
      ComputeBox(rasters_, box, field_.get());
    }
    for (const CellBox& box : changes_) MeasureTiles(box, field_.get());
    for (const CellBox& box : hard_changes_) MeasureTiles(box, field_.get());
    return Checked(Cells());
  }

  MadeBlend Whole() {
    field_->masked = RowBands<float>(field_->tiling.rows, field_->tiling.cols);
    field_->extremes.resize(field_->tiling.size());
    ForEachBand([&](int row, int row_end) {
      ComputeRows(rasters_, row, row_end, field_.get());
    });
    return Checked(rasters_.grid.size());
  }

  MadeBlend Checked(std::size_t cells) {
    const ValueExtremes all = field_->All();
    if (all.max > 0.0f && !IsComfortable(all.max)) return Slowly();
    return {field_, cells};
  }

  MadeBlend Slowly() {
    const LayerBlend blend = BlendLayers(active_, policy_, rasters_);
    field_->is_literal = policy_.paper_literal;
    field_->recipe.weights = {};
    field_->state =
        RowBands<unsigned char>(field_->tiling.rows, field_->tiling.cols);
    field_->masked = RowBands<float>(field_->tiling.rows, field_->tiling.cols);
    CloseCells(rasters_.land, field_->recipe, WholeGrid(rasters_.grid),
               &field_->state);
    // Scale by the largest magnitude, so that float32 neither overflows nor
    // loses small values.
    double max_value = 0.0;
    for (std::size_t i = 0; i < blend.masked.size(); ++i) {
      if (blend.counted[i]) {
        max_value = std::max(max_value, std::abs(blend.masked[i]));
      }
    }
    field_->unit = max_value > 0.0 ? max_value : 1.0;
    field_->extremes.assign(field_->tiling.size(), {});
    for (int tile = 0; tile < field_->tiling.size(); ++tile) {
      FillTile(blend, tile);
    }
    return {field_, rasters_.grid.size()};
  }

  void FillTile(const LayerBlend& blend, int tile) {
    const CellBox box = field_->tiling.Box(tile);
    ValueExtremes& extremes = field_->extremes[tile];
    for (int r = box.row; r < box.row_end; ++r) {
      float* row = field_->masked.RowToWrite(r);
      for (int c = box.col; c < box.col_end; ++c) {
        const std::size_t i = rasters_.grid.Index({r, c});
        row[c] = static_cast<float>(blend.masked[i] / field_->unit);
        if (blend.counted[i]) extremes = Both(extremes, {row[c], row[c]});
      }
    }
  }

  template <typename Work>
  void ForEachBand(const Work& work) const {
    const int bands = field_->tiling.bands();
    const auto one = [&](std::size_t band) {
      const int row = static_cast<int>(band) * kBandRows;
      work(row, std::min(row + kBandRows, field_->tiling.rows));
    };
    if (rasters_.grid.size() >= kThreadsFrom_cells) {
      kg_base::ForEachInParallel(bands, one);
      return;
    }
    for (int band = 0; band < bands; ++band) one(band);
  }

  const TensorInputs& in_;
  const ActiveFacts& active_;
  const Policy& policy_;
  const WindowRasters& rasters_;
  const std::shared_ptr<const BlendedField>& previous_;
  std::shared_ptr<BlendedField> field_ = std::make_shared<BlendedField>();
  bool has_same_sea_ = false;
  std::vector<CellBox> changes_;  // Changed soft zones, priors, events.
  std::vector<CellBox> hard_changes_;
};

}  // namespace

MadeBlend CompileBlend(const TensorInputs& inputs, const ActiveFacts& active,
                       const std::shared_ptr<const BlendedField>& previous) {
  return BlendCompiler(inputs, active, previous).Make();
}

}  // namespace kg_compiler
