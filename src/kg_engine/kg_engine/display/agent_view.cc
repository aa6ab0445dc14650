#include "kg_engine/display/agent_view.h"

#include <algorithm>

#include "kg_base/common/sha256.h"

namespace kg_engine {
namespace {

using kg_base::LonLat;
using kg_compiler::Compilation;
using kg_compiler::SeamRules;
using kg_compiler::WindowRules;

const SeamRules* RulesOf(const Compilation& compilation,
                         const std::string& agent_id) {
  for (const SeamRules& rules : compilation.rules) {
    if (rules.agent_id == agent_id) return &rules;
  }
  return nullptr;
}

const WindowRules* WindowOf(const SeamRules& rules, int window) {
  for (const WindowRules& candidate : rules.windows) {
    if (candidate.window == window) return &candidate;
  }
  return nullptr;
}

// Planned position of the agent at the end of a window.
std::optional<LonLat> EndOfWindow(const kg_selector::CommittedPlan& plan,
                                  const std::string& agent_id, int window) {
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    if (assignment.pathlet.agent != agent_id) continue;
    for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
      if (visit.window == window) return visit.position;
    }
  }
  return std::nullopt;
}

// Remaining part of a window that has begun.
WindowRules Rest(WindowRules window, double time_s) {
  const double begin_s = std::clamp(time_s, window.begin_s, window.end_s);
  window.base_travel_m *=
      (window.end_s - begin_s) / (window.end_s - window.begin_s);
  window.begin_s = begin_s;
  return window;
}

}  // namespace

std::optional<AgentView> AgentView::Of(const Scene& scene,
                                       const std::string& agent_id) {
  const Compilation& compilation = *scene.compilation;
  const SeamRules* rules = RulesOf(compilation, agent_id);
  const WindowRules* window = rules ? WindowOf(*rules, scene.window) : nullptr;
  if (window == nullptr || !(window->end_s > window->begin_s)) {
    return std::nullopt;
  }
  AgentView view;
  for (const auto& tensor : compilation.tensors) {
    if (tensor->agent_iri == rules->agent_iri &&
        tensor->window == scene.window) {
      view.tensor_ = tensor;
    }
  }
  for (const auto& field : compilation.fields) {
    if (field->window == scene.window) view.field_ = field;
  }
  if (!view.tensor_ || !view.field_) return std::nullopt;
  view.rules_ = *rules;
  view.window_ = *window;
  const auto pose = scene.poses.find(agent_id);
  LonLat from =
      pose == scene.poses.end() ? rules->start : pose->second.position;
  if (window == &rules->windows.front()) {
    view.window_ = Rest(*window, scene.time_s);
  } else {
    from = EndOfWindow(scene.plan, agent_id, scene.window - 1).value_or(from);
  }
  view.places_ = {from};
  return view;
}

kg_compiler::WorkMap AgentView::WorkFrom(
    const std::vector<LonLat>& places) const {
  return kg_compiler::ComputeWork(rules_, window_,
                                  {tensor_.get(), &field_->field}, places);
}

std::string AgentView::WorkKey(const std::vector<LonLat>& places) const {
  kg_base::Hasher hash;
  hash.Add(tensor_->hash);
  hash.Add(field_->hash);
  for (const double value :
       {rules_.motion.cruise_mps, rules_.motion.boost_gain, window_.begin_s,
        window_.end_s, window_.base_travel_m}) {
    hash.Add(value);
  }
  for (const LonLat& place : places) {
    hash.Add(place.lon_deg);
    hash.Add(place.lat_deg);
  }
  return hash.Hex();
}

}  // namespace kg_engine
