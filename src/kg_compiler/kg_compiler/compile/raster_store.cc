#include "kg_compiler/compile/raster_store.h"

#include <limits>
#include <utility>

#include "kg_compiler/as_sent.h"
#include "kg_core/base/input_error.h"
#include "kg_core/base/sha256.h"

namespace kg_compiler {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

const std::string& Sha256Of(const kg_core::Mission& mission,
                            const std::string& file_iri,
                            const std::string& reader_iri) {
  const auto found = mission.files.find(file_iri);
  if (found == mission.files.end()) {
    throw kg_core::InputError(reader_iri + " prov:wasDerivedFrom " + file_iri +
                              ": not an ex:SourceFile of the mission");
  }
  return found->second.sha256;
}

std::string WindowName(const kg_core::Mission& mission, int window) {
  for (const kg_core::TimeWindow& candidate : mission.windows) {
    if (candidate.index == window) return candidate.iri;
  }
  return "window " + std::to_string(window);
}

const kg_core::WorkFieldRef& FindField(const kg_core::Mission& mission,
                                       int window) {
  for (const kg_core::WorkFieldRef& field : mission.work_fields) {
    if (field.window == window) return field;
  }
  throw kg_core::InputError(WindowName(mission, window) +
                            ": no ex:WorkField ex:forWindow it");
}

const kg_core::ValueLayer& FindValue(const kg_core::Mission& mission,
                                     const kg_core::Policy& policy,
                                     int window) {
  const kg_core::ValueLayer* newest = nullptr;
  bool two = false;
  for (const kg_core::ValueLayer& layer : mission.value_layers) {
    if (layer.window != window || layer.kind != policy.value_kind) continue;
    two = newest && layer.time_index == newest->time_index;
    if (!newest || layer.time_index > newest->time_index) newest = &layer;
  }
  const std::string where = WindowName(mission, window) + ": policy " +
                            policy.iri + " reads ex:kind \"" +
                            policy.value_kind + "\", ";
  if (!newest) throw kg_core::InputError(where + "no ex:ValueLayer has it");
  if (two) {
    throw kg_core::InputError(where + "two ex:ValueLayers of one time have it");
  }
  return *newest;
}

std::string LandHash(const WindowRasters& rasters) {
  kg_core::Hasher hash;
  hash.Add(rasters.grid.Hash());
  hash.Add(std::string_view(reinterpret_cast<const char*>(rasters.land.data()),
                            rasters.land.size()));
  return hash.Hex();
}

std::string ContentHash(const WindowRasters& rasters) {
  kg_core::Hasher hash;
  hash.Add(rasters.land_hash);
  hash.Add(rasters.value);
  return hash.Hex();
}

bool ReadsValue(const kg_core::Policy& policy) {
  return policy.alpha_base != 0.0 || policy.gamma_front != 0.0;
}

template <typename Map>
void EraseUnused(Map* kept) {
  for (auto at = kept->begin(); at != kept->end();) {
    if (!at->second.used) {
      at = kept->erase(at);
    } else {
      (at++)->second.used = false;
    }
  }
}

}  // namespace

RasterReaders ReadersOf(kg_core::FileCache* files) {
  return {[files](const kg_core::Mission& mission,
                  const kg_core::WorkFieldRef& field) {
            return kg_core::LoadWorkField(*files, mission, field);
          },
          [files](const kg_core::Mission& mission,
                  const kg_core::ValueLayer& layer, const kg_core::Grid& grid) {
            return kg_core::LoadValueLayer(*files, mission, layer, grid);
          }};
}

RasterStore::RasterStore(RasterReaders readers)
    : readers_(std::move(readers)) {}

std::shared_ptr<const WorkField> RasterStore::Field(
    const kg_core::Mission& mission, int window) {
  const kg_core::WorkFieldRef& ref = FindField(mission, window);
  kg_core::Hasher key;
  key.Add(ref.iri);
  key.Add(Sha256Of(mission, ref.file_iri, ref.iri));
  key.Add(static_cast<double>(window));
  key.Add(static_cast<double>(ref.first_time_index));
  key.Add(static_cast<double>(ref.last_time_index));
  Kept<WorkField>& kept = fields_[key.Hex()];
  kept.used = true;
  if (!kept.value) {
    auto field = std::make_shared<WorkField>();
    field->window = window;
    field->iri = ref.iri;
    field->field = readers_.field(mission, ref);
    field->field.grid = AsSent(field->field.grid);
    field->hash = field->field.Hash();
    kept.value = std::move(field);
  }
  return kept.value;
}

std::shared_ptr<const WindowRasters> RasterStore::Rasters(
    const kg_core::Mission& mission, const kg_core::Policy& policy,
    const WorkField& field) {
  const kg_core::ValueLayer* layer =
      ReadsValue(policy) ? &FindValue(mission, policy, field.window) : nullptr;
  kg_core::Hasher key;
  key.Add(field.iri);
  key.Add(field.hash);
  if (layer) {
    key.Add(layer->iri);
    key.Add(layer->file_iri);
    key.Add(layer->kind);
    key.Add(Sha256Of(mission, layer->file_iri, layer->iri));
    key.Add(static_cast<double>(layer->time_index));
    key.Add(static_cast<double>(layer->previous_time_index));
  }
  Kept<WindowRasters>& kept = rasters_[key.Hex()];
  kept.used = true;
  if (kept.value) return kept.value;
  auto rasters = std::make_shared<WindowRasters>();
  rasters->grid = field.field.grid;
  rasters->land = field.field.NoData();
  rasters->field_iri = field.iri;
  rasters->value.assign(rasters->grid.size(), kNoData);
  if (layer) {
    rasters->value = readers_.value(mission, *layer, rasters->grid);
    rasters->value_iri = layer->iri;
    rasters->value_file_iri = layer->file_iri;
  }
  rasters->land_hash = LandHash(*rasters);
  rasters->content_hash = ContentHash(*rasters);
  kept.value = std::move(rasters);
  return kept.value;
}

void RasterStore::ForgetUnused() {
  EraseUnused(&fields_);
  EraseUnused(&rasters_);
}

}  // namespace kg_compiler
