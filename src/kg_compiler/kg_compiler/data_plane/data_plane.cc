#include "kg_compiler/data_plane/data_plane.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "kg_base/common/sha256.h"
#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/blend.h"
#include "kg_compiler/data_plane/compile_blend.h"
#include "kg_compiler/data_plane/compiled_tensor.h"

namespace kg_compiler {
namespace {

using kg_mission::Agent;
using kg_mission::ConfidenceMode;
using kg_mission::Mission;
using kg_mission::TimeWindow;

void CheckArguments(const Agent& agent, const WindowRasters& rasters,
                    const HorizonScale* horizon) {
  if (rasters.land.size() != rasters.grid.size() ||
      rasters.value.size() != rasters.grid.size()) {
    throw std::logic_error("land and value are not of the grid's size");
  }
  const bool wanted = agent.policy.confidence_mode == ConfidenceMode::kHorizon;
  if (wanted != (horizon != nullptr)) {
    throw std::logic_error("a horizon scale goes with that confidence mode");
  }
}

void Scale(double factor, std::vector<double>* values) {
  for (double& value : *values) value *= factor;
}

bool IsPost(const kg_mission::Policy& policy) {
  return policy.confidence_mode == ConfidenceMode::kPost &&
         !policy.paper_literal;
}

// Hashes the identity of a raster that is read from a file.
void HashRaster(const Mission& mission, const kg_mission::RasterRef& ref,
                kg_base::Hasher* hash) {
  const auto file = mission.files.find(ref.file_iri);
  hash->Add("raster");
  hash->Add(file == mission.files.end() ? ref.file_iri : file->second.sha256);
  hash->Add(ref.variable);
  hash->Add(static_cast<double>(ref.time_index));
  hash->Add(static_cast<double>(ref.resampling));
}

void HashConstraints(const Mission& mission, const ActiveFacts& active,
                     kg_base::Hasher* hash) {
  hash->Add(static_cast<double>(active.constraints.size()));
  for (const ActiveConstraint& constraint : active.constraints) {
    const kg_mission::Constraint& fact = *constraint.fact;
    hash->Add(constraint.forbids() ? 1.0 : 0.0);
    if (!constraint.forbids()) hash->Add(constraint.attenuation);
    // Only if the cover differs from the default for its effect.
    const bool is_touched =
        constraint.effect->cover == kg_base::CellCover::kTouched;
    if (is_touched != constraint.forbids()) {
      hash->Add(kg_base::Name(constraint.effect->cover));
    }
    if (fact.mask) {
      HashRaster(mission, *fact.mask, hash);
    } else {
      hash->Add(fact.area ? fact.area->Wkt() : "land");
    }
    hash->Add(fact.buffer_cells);
    const bool is_square =
        fact.buffer_metric == kg_mission::BufferMetric::kChebyshev;
    if (fact.buffer_cells > 0.0 && is_square) hash->Add("chebyshev");
  }
}

void HashPriors(const Mission& mission, const ActiveFacts& active,
                double beta_poi, kg_base::Hasher* hash) {
  hash->Add(static_cast<double>(active.priors.size()));
  for (const ActivePrior& prior : active.priors) {
    hash->Add(prior.beta);
    if (prior.fact->raster) {
      HashRaster(mission, *prior.fact->raster, hash);
      continue;
    }
    hash->Add(prior.fact->area ? prior.fact->area->Wkt() : "nothing");
    hash->Add(prior.fact->edge_m);
  }
  hash->Add(static_cast<double>(active.events.size()));
  // beta_poi matters only if there are events.
  if (!active.events.empty()) hash->Add(beta_poi);
  for (const kg_mission::Event* event : active.events) {
    hash->Add(event->position.lon_deg);
    hash->Add(event->position.lat_deg);
    hash->Add(event->value);
    hash->Add(event->radius_m);
  }
}

// Hashes each option only where it affects the result.
void HashOptions(const kg_mission::Policy& policy, const ActiveFacts& active,
                 const WindowRasters& rasters, kg_base::Hasher* hash) {
  if (policy.paper_literal) {
    hash->Add("literal");
  } else {
    hash->Add(static_cast<double>(policy.normalisation));
  }
  hash->Add(static_cast<double>(policy.confidence_mode));
  if (policy.gamma_front != 0.0) {
    hash->Add(static_cast<double>(policy.front_operator));
  }
  if (active.reads_value && !policy.paper_literal) {
    hash->Add(static_cast<double>(policy.layer_scale));
    if (policy.layer_scale == kg_mission::LayerScale::kFixed) {
      if (policy.alpha_base != 0.0) hash->Add(rasters.full_scale.value_or(0));
      if (policy.gamma_front != 0.0) {
        hash->Add(rasters.front_full_scale.value_or(0));
      }
    }
  }
  const auto is_soft = [](const ActiveConstraint& constraint) {
    return !constraint.forbids() && constraint.attenuation != 1.0;
  };
  // The combination of soft zones matters only if there are two or more.
  const bool can_overlap = std::count_if(active.constraints.begin(),
                                         active.constraints.end(), is_soft) > 1;
  if (can_overlap) hash->Add(static_cast<double>(policy.soft_overlap));
}

// Hash of exactly the inputs that CompileTensor reads.
std::string HashOf(const TensorInputs& in, const ActiveFacts& active) {
  const kg_mission::Policy& policy = in.agent->policy;
  const WindowRasters& rasters = *in.rasters;
  kg_base::Hasher hash;
  hash.Add(active.reads_value ? rasters.content_hash : rasters.land_hash);
  hash.Add(in.window->confidence);
  hash.Add(policy.alpha_base);
  hash.Add(policy.gamma_front);
  HashOptions(policy, active, rasters, &hash);
  HashConstraints(*in.mission, active, &hash);
  HashPriors(*in.mission, active, policy.beta_poi, &hash);
  if (in.horizon) {
    hash.Add(in.horizon->low);
    hash.Add(in.horizon->range);
  }
  return hash.Hex();
}

// The IRIs of the facts and files that CompileTensor reads, sorted.
std::vector<std::string> SourcesOf(const TensorInputs& in,
                                   const ActiveFacts& active) {
  std::set<std::string> sources = {in.agent->policy.iri, in.window->iri,
                                   in.rasters->field_iri};
  if (active.reads_value) {
    sources.insert({in.rasters->value_iri, in.rasters->value_file_iri});
  }
  if (active.names_agent) sources.insert(in.agent->iri);
  for (const ActiveConstraint& constraint : active.constraints) {
    sources.insert({constraint.fact->iri, constraint.override_iri});
    if (constraint.fact->mask) sources.insert(constraint.fact->mask->file_iri);
    sources.insert(constraint.avoided_by.begin(), constraint.avoided_by.end());
  }
  for (const ActivePrior& prior : active.priors) {
    sources.insert({prior.fact->iri, prior.weight_iri});
    if (prior.fact->raster) sources.insert(prior.fact->raster->file_iri);
  }
  for (const kg_mission::Event* event : active.events) {
    sources.insert(event->iri);
  }
  sources.erase("");  // Entries of absent rasters and overrides.
  return {sources.begin(), sources.end()};
}

}  // namespace

HorizonScale MeasureHorizon(
    const Mission& mission, const Agent& agent,
    const std::vector<std::shared_ptr<const WindowRasters>>& rasters,
    DataPlaneCache* cache) {
  ValueNormaliser all;
  std::set<std::string> sources;
  for (std::size_t i = 0; i < mission.windows.size(); ++i) {
    const TimeWindow& window = mission.windows[i];
    const WindowRasters& here = *rasters.at(i);
    const ActiveFacts active = FindActiveFacts(mission, agent, window);
    const TensorInputs inputs{&mission, &agent, &window, &here, nullptr, cache};
    const MadeBlend made = CompileBlend(inputs, active, nullptr);
    const RowScale n = FitScale(*made.field, agent.policy,
                                static_cast<float>(window.confidence), nullptr);
    // Convert from the field's unit; constant zero windows do not contribute.
    const ValueNormaliser own{n.low * made.field->unit,
                              n.range * made.field->unit};
    if (own.range > 0.0) all = all.range > 0.0 ? Merge(all, own) : own;
    for (std::string& iri : SourcesOf(inputs, active)) {
      sources.insert(std::move(iri));
    }
  }
  return {all.low, all.range, {sources.begin(), sources.end()}};
}

HorizonScale MeasureHorizon(const Mission& mission, const Agent& agent,
                            const std::vector<WindowRasters>& rasters) {
  std::vector<std::shared_ptr<const WindowRasters>> pointers;
  for (const WindowRasters& window : rasters) {
    pointers.emplace_back(std::shared_ptr<const void>(), &window);
  }
  return MeasureHorizon(mission, agent, pointers, nullptr);
}

TensorBlend BlendTensor(const Agent& agent, const TimeWindow& window,
                        const WindowRasters& rasters, const ActiveFacts& active,
                        const HorizonScale* horizon) {
  const kg_mission::Policy& policy = agent.policy;
  TensorBlend made;
  made.blend = BlendLayers(active, policy, rasters);
  const bool post = IsPost(policy);
  (post ? made.after : made.before) = window.confidence;
  if (!post) Scale(window.confidence, &made.blend.masked);
  const kg_mission::Normalisation kind =
      policy.paper_literal ? kg_mission::Normalisation::kMinMax
                           : policy.normalisation;
  made.n = horizon ? ValueNormaliser{horizon->low, horizon->range}
                   : FitNormaliser(made.blend.masked, made.blend.counted, kind);
  return made;
}

MissionTensor CompileTensor(const Mission& mission, const Agent& agent,
                            const TimeWindow& window,
                            const WindowRasters& rasters,
                            const HorizonScale* horizon) {
  return CompileTensor({&mission, &agent, &window, &rasters, horizon}, nullptr);
}

TensorRequest PrepareTensor(const TensorInputs& inputs) {
  TensorRequest request;
  request.inputs = inputs;
  request.active =
      FindActiveFacts(*inputs.mission, *inputs.agent, *inputs.window);
  request.hash = HashOf(inputs, request.active);
  request.sources = inputs.horizon ? inputs.horizon->derived_from
                                   : SourcesOf(inputs, request.active);
  return request;
}

MissionTensor CompileTensor(const TensorInputs& inputs,
                            const MissionTensor* previous) {
  return CompilePrepared(PrepareTensor(inputs), previous);
}

MissionTensor CompilePrepared(const TensorRequest& request,
                              const MissionTensor* previous) {
  const TensorInputs& inputs = request.inputs;
  const Agent& agent = *inputs.agent;
  const TimeWindow& window = *inputs.window;
  const WindowRasters& rasters = *inputs.rasters;
  CheckArguments(agent, rasters, inputs.horizon);
  MissionTensor tensor;
  tensor.agent_iri = agent.iri;
  tensor.window = window.index;
  tensor.confidence = window.confidence;
  tensor.grid = rasters.grid;
  tensor.hash = request.hash;
  tensor.derived_from = request.sources;
  if (previous && previous->hash == tensor.hash) {
    tensor.content = previous->content;
    return tensor;
  }
  const auto* before =
      previous ? dynamic_cast<const CompiledTensor*>(previous->content.get())
               : nullptr;
  const MadeBlend made =
      CompileBlend(inputs, request.active, before ? before->field() : nullptr);
  // The confidence w_t is applied before or after N; after it in mode `post`,
  // because N would cancel it (A1).
  const float w = static_cast<float>(window.confidence);
  const bool post = IsPost(agent.policy);
  RowScale scale =
      FitScale(*made.field, agent.policy, post ? 1.0f : w, inputs.horizon);
  scale.after = post ? w : 1.0f;
  tensor.content =
      std::make_shared<CompiledTensor>(made.field, scale, window.confidence);
  tensor.cells_computed = made.cells;
  return tensor;
}

std::string TensorHash(const Mission& mission, const Agent& agent,
                       const TimeWindow& window, const WindowRasters& rasters,
                       const HorizonScale* horizon) {
  const TensorInputs inputs{&mission, &agent, &window, &rasters, horizon};
  return HashOf(inputs, FindActiveFacts(mission, agent, window));
}

}  // namespace kg_compiler
