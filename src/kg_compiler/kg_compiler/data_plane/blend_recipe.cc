#include "kg_compiler/data_plane/blend_recipe.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace kg_compiler {
namespace {

// Sort keys; equal keys mean equal rasters.
auto Order(const HardZone& zone) { return std::tie(zone.patch->key); }
auto Order(const SoftZone& zone) {
  return std::tie(zone.patch->key, zone.factor);
}
auto Order(const WeightedPatch& prior) {
  return std::tie(prior.patch->key, prior.weight);
}

template <typename T>
bool Before(const T& a, const T& b) {
  return Order(a) < Order(b);
}

template <typename T>
std::vector<CellBox> Changes(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> changed;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                std::back_inserter(changed), Before<T>);
  std::vector<CellBox> boxes;
  for (const T& item : changed) {
    if (!item.patch->box.empty()) boxes.push_back(item.patch->box);
  }
  return boxes;
}

template <typename T>
auto FindPatch(const std::vector<T>& items, const std::string& key)
    -> decltype(items[0].patch) {
  for (const T& item : items) {
    if (item.patch->key == key) return item.patch;
  }
  return nullptr;
}

class RecipeWriter {
 public:
  RecipeWriter(const kg_mission::Mission& mission, const WindowRasters& rasters,
               const BlendRecipe* known, DataPlaneCache* cache)
      : mission_(mission), rasters_(rasters), known_(known), cache_(cache) {}

  std::shared_ptr<const MaskPatch> Extent(const ActiveConstraint& constraint) {
    const std::string key = ConstraintKey(mission_, constraint);
    if (known_) {
      if (auto found = FindPatch(known_->hard, key)) return found;
      if (auto found = FindPatch(known_->soft, key)) return found;
    }
    const auto make = [&] {
      return std::make_shared<const MaskPatch>(
          ConstraintPatch(rasters_, constraint, key));
    };
    return cache_ ? cache_->Mask(rasters_.land_hash, key, make) : make();
  }

  template <typename Make>
  std::shared_ptr<const ValuePatch> Values(const std::string& key,
                                           const Make& make_patch) {
    if (known_) {
      if (auto found = FindPatch(known_->priors, key)) return found;
    }
    const auto make = [&] {
      return std::make_shared<const ValuePatch>(make_patch());
    };
    return cache_ ? cache_->Values(rasters_.land_hash, key, make) : make();
  }

 private:
  const kg_mission::Mission& mission_;
  const WindowRasters& rasters_;
  const BlendRecipe* known_;
  DataPlaneCache* cache_;
};

}  // namespace

BlendRecipe WriteRecipe(const kg_mission::Mission& mission,
                        const kg_mission::Policy& policy,
                        const ActiveFacts& active, const WindowRasters& rasters,
                        const BlendRecipe* known, DataPlaneCache* cache) {
  const bool is_same_sea = known && known->land_hash == rasters.land_hash;
  RecipeWriter writer(mission, rasters, is_same_sea ? known : nullptr, cache);
  BlendRecipe recipe;
  recipe.land_hash = rasters.land_hash;
  if (active.reads_value) recipe.content_hash = rasters.content_hash;
  recipe.overlap = policy.soft_overlap;
  // Masks: hard zones, and soft zones whose factor changes anything.
  for (const ActiveConstraint& constraint : active.constraints) {
    if (constraint.forbids()) {
      recipe.hard.push_back({writer.Extent(constraint)});
    } else if (constraint.attenuation != 1.0) {
      recipe.soft.push_back({writer.Extent(constraint),
                             static_cast<float>(constraint.attenuation)});
    }
  }
  for (const ActivePrior& prior : active.priors) {
    const std::string key = PriorKey(mission, *prior.fact);
    recipe.priors.push_back(
        {writer.Values(key,
                       [&] { return PriorPatch(rasters, *prior.fact, key); }),
         static_cast<float>(prior.beta)});
  }
  // Events are priors of weight beta_poi * value; without radius there is no
  // bump (A42).
  for (const kg_mission::Event* event : active.events) {
    if (!(event->radius_m > 0.0)) continue;
    const std::string key = BumpKey(*event);
    recipe.priors.push_back(
        {writer.Values(key,
                       [&] { return BumpPatch(rasters.grid, *event, key); }),
         static_cast<float>(policy.beta_poi * event->value)});
  }
  // Sorted by key, so that equal inputs give equal recipes.
  std::sort(recipe.hard.begin(), recipe.hard.end(), Before<HardZone>);
  std::sort(recipe.soft.begin(), recipe.soft.end(), Before<SoftZone>);
  std::sort(recipe.priors.begin(), recipe.priors.end(), Before<WeightedPatch>);
  return recipe;
}

std::vector<CellBox> HardChanges(const BlendRecipe& a, const BlendRecipe& b) {
  return Changes(a.hard, b.hard);
}
std::vector<CellBox> SoftChanges(const BlendRecipe& a, const BlendRecipe& b) {
  return Changes(a.soft, b.soft);
}
std::vector<CellBox> PriorChanges(const BlendRecipe& a, const BlendRecipe& b) {
  return Changes(a.priors, b.priors);
}

}  // namespace kg_compiler
