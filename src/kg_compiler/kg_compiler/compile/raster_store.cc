#include "kg_compiler/compile/raster_store.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_compiler/compile/as_sent.h"
#include "kg_compiler/data_plane/frontness.h"
#include "kg_compiler/data_plane/masks.h"
#include "kg_core/rdf/term.h"
#include "kg_mission/mission/layer_files.h"
#include "kg_mission/mission/scope.h"

namespace kg_compiler {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

std::string Turtle(const std::string& iri) {
  return kg_core::ToTurtle(kg_core::Iri(iri));
}

const std::string& Sha256Of(const kg_mission::Mission& mission,
                            const std::string& file_iri,
                            const std::string& reader_iri) {
  const auto found = mission.files.find(file_iri);
  if (found == mission.files.end()) {
    throw kg_base::InputError(reader_iri + " prov:wasDerivedFrom " + file_iri +
                              ": not an ex:SourceFile of the mission");
  }
  return found->second.sha256;
}

std::string WindowName(const kg_mission::Mission& mission, int window) {
  for (const kg_mission::TimeWindow& candidate : mission.windows) {
    if (candidate.index == window) return candidate.iri;
  }
  return "window " + std::to_string(window);
}

const kg_mission::WorkFieldRef& FindField(const kg_mission::Mission& mission,
                                          int window) {
  for (const kg_mission::WorkFieldRef& field : mission.work_fields) {
    if (field.window == window) return field;
  }
  throw kg_base::InputError(WindowName(mission, window) +
                            ": no ex:WorkField ex:forWindow it");
}

std::string FieldKey(const kg_mission::Mission& mission,
                     const kg_mission::WorkFieldRef& ref) {
  kg_base::Hasher key;
  key.Add(ref.iri);
  key.Add(Sha256Of(mission, ref.file_iri, ref.iri));
  key.Add(static_cast<double>(ref.window));
  key.Add(static_cast<double>(ref.first_time_index));
  key.Add(static_cast<double>(ref.last_time_index));
  for (const kg_mission::CostFieldRef& cost : mission.cost_fields) {
    if (cost.window != ref.window) continue;
    key.Add(cost.iri);
    key.Add(cost.quantity);
    key.Add(Sha256Of(mission, cost.file_iri, cost.iri));
    key.Add(static_cast<double>(cost.first_time_index));
    key.Add(static_cast<double>(cost.last_time_index));
    key.Add(static_cast<double>(cost.resampling));
  }
  return key.Hex();
}

// Age comparison: < 0: a is older. 0: same or unknown time.
double Compare(const kg_mission::ValueLayer& a,
               const kg_mission::ValueLayer& b) {
  if (a.time_s && b.time_s) return *a.time_s - *b.time_s;
  return a.file_iri == b.file_iri ? a.time_index - b.time_index : 0;
}

const kg_mission::ValueLayer& FindValue(const kg_mission::Mission& mission,
                                        const kg_mission::Policy& policy,
                                        int window) {
  const kg_mission::ValueLayer* newest = nullptr;
  bool two = false;
  for (const kg_mission::ValueLayer& layer : mission.value_layers) {
    if (layer.window != window || layer.kind != policy.value_kind) continue;
    // With equal times no layer is the newest.
    const double newer_by = newest ? Compare(layer, *newest) : 1.0;
    if (newer_by == 0.0) two = true;
    if (!(newer_by > 0.0)) continue;
    newest = &layer;
    two = false;
  }
  const std::string where = WindowName(mission, window) + ": policy " +
                            policy.iri + " reads ex:kind \"" +
                            policy.value_kind + "\", ";
  if (!newest) throw kg_base::InputError(where + "no ex:ValueLayer has it");
  if (two) {
    throw kg_base::InputError(where + "two ex:ValueLayers of one time have it");
  }
  return *newest;
}

std::string LandHash(const WindowRasters& rasters) {
  kg_base::Hasher hash;
  hash.Add(rasters.grid.Hash());
  hash.Add(std::string_view(reinterpret_cast<const char*>(rasters.land.data()),
                            rasters.land.size()));
  return hash.Hex();
}

std::string ContentHash(const WindowRasters& rasters) {
  kg_base::Hasher hash;
  hash.Add(rasters.land_hash);
  hash.Add(rasters.value);
  return hash.Hex();
}

bool ReadsValue(const kg_mission::Policy& policy) {
  return policy.alpha_base != 0.0 || policy.gamma_front != 0.0;
}

// Throws if the policy requires a scale that the layer does not have.
void CheckScales(const kg_mission::Policy& policy,
                 const kg_mission::ValueLayer& layer) {
  if (policy.layer_scale != kg_mission::LayerScale::kFixed) return;
  if (policy.paper_literal) return;
  const auto need = [&](const char* name) {
    throw kg_base::InputError(Turtle(layer.iri) + " " + name +
                              ": expected a number above 0, because policy " +
                              Turtle(policy.iri) +
                              " has ex:layerScale \"fixed\"");
  };
  if (policy.alpha_base != 0.0 && !layer.full_scale) need("ex:fullScale");
  if (policy.gamma_front != 0.0 && !layer.front_full_scale) {
    need("ex:frontFullScale");
  }
}

bool IsWeighed(const kg_mission::Policy& policy,
               const kg_mission::PriorLayer& prior) {
  const auto beta = policy.beta.find(prior.iri);
  return beta != policy.beta.end() && beta->second != 0.0;
}

bool MustBeAvoided(const kg_mission::Mission& mission,
                   const kg_mission::Constraint& constraint) {
  return std::any_of(mission.agents.begin(), mission.agents.end(),
                     [&](const kg_mission::Agent& agent) {
                       return agent.must_avoid.count(constraint.iri) > 0;
                     });
}

std::string KeyOf(const kg_mission::Mission& mission, const std::string& iri,
                  const kg_mission::RasterRef& ref,
                  const std::string& grid_hash) {
  kg_base::Hasher key;
  key.Add(Sha256Of(mission, ref.file_iri, iri));
  key.Add(ref.variable);
  key.Add(static_cast<double>(ref.time_index));
  key.Add(static_cast<double>(ref.resampling));
  key.Add(grid_hash);
  return key.Hex();
}

kg_base::Raster ReadValue(kg_mission::FileCache* files,
                          const kg_mission::Mission& mission,
                          const kg_mission::ValueLayer& layer,
                          const kg_base::Grid& grid) {
  kg_mission::GriddedRaster own = LoadValueLayer(*files, mission, layer);
  if (layer.kind == kg_mission::kFrontnessKind) {
    own.values = GradientPerKm(own.grid, own.values);
  }
  return OnGrid(layer.iri, own, grid, layer.resampling);
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

RasterReaders ReadersOf(kg_mission::FileCache* files) {
  return {
      [files](const kg_mission::Mission& mission,
              const kg_mission::WorkFieldRef& field) {
        return kg_mission::LoadWorkField(*files, mission, field);
      },
      [files](const kg_mission::Mission& mission,
              const kg_mission::ValueLayer& layer, const kg_base::Grid& grid) {
        return ReadValue(files, mission, layer, grid);
      },
      [files](const kg_mission::Mission& mission, const std::string& iri,
              const kg_mission::RasterRef& ref,
              const kg_base::Grid& grid) -> kg_base::Raster {
        return OnGrid(iri, LoadRaster(*files, mission, ref), grid,
                      ref.resampling);
      }};
}

RasterStore::RasterStore(RasterReaders readers)
    : readers_(std::move(readers)) {}

std::shared_ptr<const WorkField> RasterStore::Field(
    const kg_mission::Mission& mission, int window) {
  const kg_mission::WorkFieldRef& ref = FindField(mission, window);
  Kept<WorkField>& kept = fields_[FieldKey(mission, ref)];
  kept.used = true;
  if (!kept.value) {
    auto field = std::make_shared<WorkField>();
    field->window = window;
    field->iri = ref.iri;
    field->field = readers_.field(mission, ref);
    field->field.grid = AsSent(field->field.grid);
    field->hash = field->field.Hash();
    CheckGrid(mission, *field);
    kept.value = std::move(field);
  }
  return kept.value;
}

// Checks the grid against that of any other window already loaded.
void RasterStore::CheckGrid(const kg_mission::Mission& mission,
                            const WorkField& field) const {
  for (const kg_mission::WorkFieldRef& ref : mission.work_fields) {
    const auto other = fields_.find(FieldKey(mission, ref));
    if (other == fields_.end() || !other->second.value) continue;
    const kg_base::Grid& grid = other->second.value->field.grid;
    if (grid == field.field.grid) return;
    throw kg_base::InputError(Turtle(field.iri) + ": expected the grid of " +
                              Turtle(ref.iri) + " (" + grid.Text() +
                              "), because one grid is the mission's, not " +
                              field.field.grid.Text());
  }
}

template <typename T, typename Make>
std::shared_ptr<const T> RasterStore::Keep(const FileRequest& request,
                                           std::map<std::string, Kept<T>>* kept,
                                           const Make& make,
                                           std::string* read) {
  if (request.grid->hash.empty()) {
    request.grid->hash = request.grid->grid.Hash();
  }
  const std::string key =
      KeyOf(*request.mission, request.iri, request.ref, request.grid->hash);
  Kept<T>& place = (*kept)[key];
  place.used = true;
  if (!place.value) {
    place.value = make(readers_.raster(*request.mission, request.iri,
                                       request.ref, request.grid->grid));
  }
  *read += request.iri + " " + key + "\n";
  return place.value;
}

RasterStore::FromFiles RasterStore::ReadFiles(
    const kg_mission::Mission& mission, const kg_mission::Policy& policy,
    const WorkField& field) {
  FromFiles read;
  HashedGrid grid{field.field.grid, ""};
  for (const kg_mission::PriorLayer& prior : mission.priors) {
    if (!prior.raster || !IsWeighed(policy, prior)) continue;
    if (!kg_mission::InScope(prior.windows, field.window)) continue;
    read.priors[prior.iri] = Keep(
        {&mission, prior.iri, *prior.raster, &grid}, &priors_,
        [](kg_base::Raster values) {
          return std::make_shared<const kg_base::Raster>(std::move(values));
        },
        &read.key);
  }
  for (const kg_mission::Constraint& constraint : mission.constraints) {
    if (!constraint.mask) continue;
    if (!kg_mission::InScope(constraint.windows, field.window)) continue;
    ReadMask(mission, constraint, &grid, &read);
  }
  return read;
}

void RasterStore::ReadMask(const kg_mission::Mission& mission,
                           const kg_mission::Constraint& constraint,
                           HashedGrid* grid, FromFiles* read) {
  const int margin = BufferMargin(constraint, grid->grid);
  HashedGrid extended{grid->grid.Extended(margin), ""};
  FileRequest request{&mission, constraint.iri, *constraint.mask,
                      margin == 0 ? grid : &extended};
  const auto keep = [&] {
    return Keep(
        request, &masks_,
        [](const kg_base::Raster& values) {
          return std::make_shared<const kg_base::Mask>(
              kg_mission::MakeMask(values));
        },
        &read->key);
  };
  const kg_mission::ConstraintEffect& effect =
      kg_mission::EffectOf(constraint.kind);
  const bool is_resampled =
      request.ref.resampling != kg_base::Resampling::kNone;
  if (!is_resampled || effect.cover == kg_base::CellCover::kCentres) {
    read->masks[constraint.iri] = keep();
  }
  if (!is_resampled) return;
  // What is forbidden must not be lost between the centres of the cells.
  request.ref.resampling = kg_base::Resampling::kTouched;
  if (effect.cover == kg_base::CellCover::kTouched) {
    read->masks[constraint.iri] = keep();
  } else if (MustBeAvoided(mission, constraint)) {
    read->avoided_masks[constraint.iri] = keep();
  }
}

std::shared_ptr<const WindowRasters> RasterStore::Rasters(
    const kg_mission::Mission& mission, const kg_mission::Policy& policy,
    const WorkField& field) {
  const kg_mission::ValueLayer* layer =
      ReadsValue(policy) ? &FindValue(mission, policy, field.window) : nullptr;
  if (layer) CheckScales(policy, *layer);
  FromFiles files = ReadFiles(mission, policy, field);
  kg_base::Hasher key;
  key.Add(field.iri);
  key.Add(field.hash);
  key.Add(files.key);
  if (layer) {
    key.Add(layer->iri);
    key.Add(layer->file_iri);
    key.Add(layer->kind);
    key.Add(Sha256Of(mission, layer->file_iri, layer->iri));
    key.Add(static_cast<double>(layer->time_index));
    key.Add(static_cast<double>(layer->previous_time_index));
    key.Add(static_cast<double>(layer->resampling));
    key.Add(layer->full_scale.value_or(0.0));
    key.Add(layer->front_full_scale.value_or(0.0));
  }
  // Land comes from the field; without a value layer all is no data.
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
    rasters->full_scale = layer->full_scale;
    rasters->front_full_scale = layer->front_full_scale;
  }
  rasters->prior_rasters = std::move(files.priors);
  rasters->constraint_masks = std::move(files.masks);
  rasters->avoided_masks = std::move(files.avoided_masks);
  rasters->land_hash = LandHash(*rasters);
  rasters->content_hash = ContentHash(*rasters);
  kept.value = std::move(rasters);
  return kept.value;
}

void RasterStore::ForgetUnused() {
  EraseUnused(&fields_);
  EraseUnused(&rasters_);
  EraseUnused(&priors_);
  EraseUnused(&masks_);
}

}  // namespace kg_compiler
