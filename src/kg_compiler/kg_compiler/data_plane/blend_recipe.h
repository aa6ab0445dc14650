// What a blend is made of, with everything looked up: the masks, the priors and
// the factors of B and F. Two blends of one recipe are the same bits; what two
// recipes differ in says which cells to make again.

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

// Lists are in the order of keys, so that what stays between two recipes stays
// in order, and names do not matter.
struct BlendRecipe {
  std::string land_hash;
  std::string content_hash;  // Empty if B is not read.
  std::vector<HardZone> hard;
  std::vector<SoftZone> soft;
  std::vector<WeightedPatch> priors;  // And events.
  kg_mission::SoftOverlap overlap = kg_mission::SoftOverlap::kProduct;
  LayerTable::Weights weights;  // Set last: by M_hard and the layers' scales.
};

// All but the weights. Takes patches from `known`, if it is of the same grid
// and land, from the cache, or makes them.
BlendRecipe WriteRecipe(const kg_mission::Mission& mission,
                        const kg_mission::Policy& policy,
                        const ActiveFacts& active, const WindowRasters& rasters,
                        const BlendRecipe* known, DataPlaneCache* cache);

// The boxes in which two recipes of one land differ.
std::vector<CellBox> HardChanges(const BlendRecipe& a, const BlendRecipe& b);
std::vector<CellBox> SoftChanges(const BlendRecipe& a, const BlendRecipe& b);
std::vector<CellBox> PriorChanges(const BlendRecipe& a, const BlendRecipe& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BLEND_RECIPE_H_
