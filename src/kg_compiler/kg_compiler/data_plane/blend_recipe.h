// All inputs of a blend, resolved: the masks, the priors and the factors of B
// and F. Blends of equal recipes are bit-identical; the difference of two
// recipes determines which cells to recompute.

#ifndef KG_COMPILER_DATA_PLANE_BLEND_RECIPE_H_
#define KG_COMPILER_DATA_PLANE_BLEND_RECIPE_H_

#include <memory>
#include <string>
#include <vector>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/data_plane_cache.h"
#include "kg_compiler/data_plane/layer_table.h"
#include "kg_compiler/data_plane/patches.h"
#include "kg_compiler/data_plane/window_rasters.h"

namespace kg_compiler {

struct HardZone {
  std::shared_ptr<const MaskPatch> patch;
};
struct SoftZone {
  std::shared_ptr<const MaskPatch> patch;
  float factor = 1.0f;
};
struct WeightedPatch {
  std::shared_ptr<const ValuePatch> patch;
  float weight = 0.0f;
};

// Lists are sorted by key, so that items common to two recipes have the same
// order, independent of names.
struct BlendRecipe {
  std::string land_hash;
  std::string content_hash;  // Empty if B is not read.
  std::vector<HardZone> hard;
  std::vector<SoftZone> soft;
  std::vector<WeightedPatch> priors;  // Priors and events.
  kg_mission::SoftOverlap overlap = kg_mission::SoftOverlap::kProduct;
  LayerTable::Weights weights;  // Set last: depend on M_hard and the scales.
};

// Fills all but the weights. Takes patches from `known`, if it has the same
// grid and land, or from the cache; computes the others.
BlendRecipe WriteRecipe(const kg_mission::Mission& mission,
                        const kg_mission::Policy& policy,
                        const ActiveFacts& active, const WindowRasters& rasters,
                        const BlendRecipe* known, DataPlaneCache* cache);

// Boxes in which two recipes with the same land differ.
std::vector<CellBox> HardChanges(const BlendRecipe& a, const BlendRecipe& b);
std::vector<CellBox> SoftChanges(const BlendRecipe& a, const BlendRecipe& b);
std::vector<CellBox> PriorChanges(const BlendRecipe& a, const BlendRecipe& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BLEND_RECIPE_H_
