#include "kg_compiler/data_plane/data_plane.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/blend.h"
#include "kg_core/base/sha256.h"

namespace kg_compiler {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

using kg_core::Agent;
using kg_core::ConfidenceMode;
using kg_core::Mission;
using kg_core::TimeWindow;

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

BlendInputs InputsOf(const WindowRasters& rasters) {
  return {rasters.grid, rasters.land, rasters.value};
}

void Scale(double factor, std::vector<double>* values) {
  for (double& value : *values) value *= factor;
}

kg_core::Raster Reward(const Blend& blend, const Normaliser& n,
                       const kg_core::Mask& land) {
  kg_core::Raster reward(blend.masked.size(), 0.0f);
  for (std::size_t i = 0; i < reward.size(); ++i) {
    if (!land[i]) reward[i] = static_cast<float>(n.Apply(blend.masked[i]));
  }
  return reward;
}

kg_core::Raster Feasibility(const kg_core::Mask& open,
                            const kg_core::Mask& land) {
  kg_core::Raster feasibility(open.begin(), open.end());
  for (std::size_t i = 0; i < feasibility.size(); ++i) {
    if (land[i]) feasibility[i] = kNoData;
  }
  return feasibility;
}

kg_core::Raster Fused(const kg_core::Raster& reward, const kg_core::Mask& open,
                      double weight) {
  kg_core::Raster fused(reward.size(), 0.0f);
  for (std::size_t i = 0; i < fused.size(); ++i) {
    if (open[i]) fused[i] = static_cast<float>(weight * reward[i]);
  }
  return fused;
}

void AddLayers(const Blend& blend, const kg_core::Mask& land,
               kg_core::Raster reward, double weight, MissionTensor* tensor) {
  const std::size_t size = land.size();
  const float doubt = static_cast<float>(1.0 - tensor->confidence);
  kg_core::Raster fused = Fused(reward, blend.open, weight);
  tensor->content = HoldLayers({
      {Layer::kReward, std::move(reward)},
      {Layer::kUncertainty, kg_core::Raster(size, doubt)},
      {Layer::kPolicy,
       kg_core::Raster(blend.priors.begin(), blend.priors.end())},
      {Layer::kAttenuation,
       kg_core::Raster(blend.attenuation.begin(), blend.attenuation.end())},
      {Layer::kFeasibility, Feasibility(blend.open, land)},
      {Layer::kFused, std::move(fused)},
  });
}

void HashConstraints(const ActiveFacts& active, kg_core::Hasher* hash) {
  hash->Add(static_cast<double>(active.constraints.size()));
  for (const ActiveConstraint& constraint : active.constraints) {
    const kg_core::Constraint& fact = *constraint.fact;
    hash->Add(constraint.hard ? 1.0 : 0.0);
    if (!constraint.hard) hash->Add(constraint.attenuation);
    hash->Add(fact.area ? fact.area->Wkt() : "land");
    hash->Add(fact.buffer_cells);
  }
}

void HashPriors(const ActiveFacts& active, double beta_poi,
                kg_core::Hasher* hash) {
  hash->Add(static_cast<double>(active.priors.size()));
  for (const ActivePrior& prior : active.priors) {
    hash->Add(prior.beta);
    hash->Add(prior.fact->area->Wkt());
    hash->Add(prior.fact->edge_m);
  }
  hash->Add(static_cast<double>(active.events.size()));
  if (!active.events.empty()) hash->Add(beta_poi);
  for (const kg_core::Event* event : active.events) {
    hash->Add(event->position.lon_deg);
    hash->Add(event->position.lat_deg);
    hash->Add(event->value);
    hash->Add(event->radius_m);
  }
}

}  // namespace

HorizonScale MeasureHorizon(const Mission& mission, const Agent& agent,
                            const std::vector<WindowRasters>& rasters) {
  Normaliser all;
  std::set<std::string> sources;
  for (std::size_t i = 0; i < mission.windows.size(); ++i) {
    const TimeWindow& window = mission.windows[i];
    const ActiveFacts active = FindActiveFacts(mission, agent, window);
    Blend blend = BlendLayers(active, agent.policy, InputsOf(rasters.at(i)));
    Scale(window.confidence, &blend.masked);
    const Normaliser own =
        FitNormaliser(blend.masked, blend.open, agent.policy.normalisation);
    if (own.range > 0.0) all = all.range > 0.0 ? Merge(all, own) : own;
    for (std::string& iri :
         TensorSources(mission, agent, window, rasters.at(i))) {
      sources.insert(std::move(iri));
    }
  }
  return {all.low, all.range, {sources.begin(), sources.end()}};
}

TensorBlend BlendTensor(const Agent& agent, const TimeWindow& window,
                        const WindowRasters& rasters, const ActiveFacts& active,
                        const HorizonScale* horizon) {
  const kg_core::Policy& policy = agent.policy;
  TensorBlend made;
  made.blend = BlendLayers(active, policy, InputsOf(rasters));
  const bool post = policy.confidence_mode == ConfidenceMode::kPost;
  (post ? made.after : made.before) = window.confidence;
  if (!post) Scale(window.confidence, &made.blend.masked);
  made.n = horizon ? Normaliser{horizon->low, horizon->range}
                   : FitNormaliser(made.blend.masked, made.blend.open,
                                   policy.normalisation);
  return made;
}

MissionTensor CompileTensor(const Mission& mission, const Agent& agent,
                            const TimeWindow& window,
                            const WindowRasters& rasters,
                            const HorizonScale* horizon) {
  return CompileTensor({&mission, &agent, &window, &rasters, horizon}, nullptr);
}

MissionTensor CompileTensor(const TensorInputs& inputs,
                            const MissionTensor* previous) {
  const Mission& mission = *inputs.mission;
  const Agent& agent = *inputs.agent;
  const TimeWindow& window = *inputs.window;
  const WindowRasters& rasters = *inputs.rasters;
  const HorizonScale* horizon = inputs.horizon;
  CheckArguments(agent, rasters, horizon);
  const ActiveFacts active = FindActiveFacts(mission, agent, window);
  MissionTensor tensor;
  tensor.agent_iri = agent.iri;
  tensor.window = window.index;
  tensor.confidence = window.confidence;
  tensor.grid = rasters.grid;
  tensor.hash = TensorHash(mission, agent, window, rasters, horizon);
  tensor.derived_from = horizon
                            ? horizon->derived_from
                            : TensorSources(mission, agent, window, rasters);
  if (previous && previous->hash == tensor.hash) {
    tensor.content = previous->content;
    return tensor;
  }
  const TensorBlend made = BlendTensor(agent, window, rasters, active, horizon);
  AddLayers(made.blend, rasters.land, Reward(made.blend, made.n, rasters.land),
            made.after, &tensor);
  tensor.cells_computed = rasters.grid.size();
  return tensor;
}

std::string TensorHash(const Mission& mission, const Agent& agent,
                       const TimeWindow& window, const WindowRasters& rasters,
                       const HorizonScale* horizon) {
  const ActiveFacts active = FindActiveFacts(mission, agent, window);
  const kg_core::Policy& policy = agent.policy;
  kg_core::Hasher hash;
  hash.Add(active.reads_value ? rasters.content_hash : rasters.land_hash);
  hash.Add(window.confidence);
  hash.Add(policy.alpha_base);
  hash.Add(policy.gamma_front);
  hash.Add(static_cast<double>(policy.normalisation));
  hash.Add(static_cast<double>(policy.confidence_mode));
  HashConstraints(active, &hash);
  HashPriors(active, policy.beta_poi, &hash);
  if (horizon) {
    hash.Add(horizon->low);
    hash.Add(horizon->range);
  }
  return hash.Hex();
}

std::vector<std::string> TensorSources(const Mission& mission,
                                       const Agent& agent,
                                       const TimeWindow& window,
                                       const WindowRasters& rasters) {
  const ActiveFacts active = FindActiveFacts(mission, agent, window);
  std::set<std::string> sources = {agent.policy.iri, window.iri,
                                   rasters.field_iri};
  if (active.reads_value) {
    sources.insert({rasters.value_iri, rasters.value_file_iri});
  }
  if (active.names_agent) sources.insert(agent.iri);
  for (const ActiveConstraint& constraint : active.constraints) {
    sources.insert({constraint.fact->iri, constraint.override_iri});
    sources.insert(constraint.avoided_by.begin(), constraint.avoided_by.end());
  }
  for (const ActivePrior& prior : active.priors) {
    sources.insert({prior.fact->iri, prior.weight_iri});
  }
  for (const kg_core::Event* event : active.events) sources.insert(event->iri);
  sources.erase("");
  return {sources.begin(), sources.end()};
}

}  // namespace kg_compiler
