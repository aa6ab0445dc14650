#include "kg_compiler/compile/mission_compiler.h"

#include <chrono>
#include <tuple>
#include <utility>

namespace kg_compiler {
namespace {

using kg_core::Agent;
using kg_core::TimeWindow;

// Adds the time since it was made, or since the last time, to a stage.
class StageClock {
 public:
  explicit StageClock(std::map<std::string, double>* stages)
      : stages_(stages) {}
  void End(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    (*stages_)[stage] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  std::map<std::string, double>* stages_;
  std::chrono::steady_clock::time_point last_ =
      std::chrono::steady_clock::now();
};

auto Tie(const kg_core::CoordinationFacts& f) {
  return std::tie(f.mode, f.separation_m, f.separation_is_hard,
                  f.separation_weight, f.candidates_per_agent,
                  f.waypoints_per_window, f.waypoint_spacing_m, f.max_rounds);
}

bool Same(const CoordinationRules& a, const CoordinationRules& b) {
  return Tie(a.facts) == Tie(b.facts) && a.event_capacity == b.event_capacity;
}

CoordinationRules Coordinate(const kg_core::Mission& mission) {
  CoordinationRules rules{mission.coordination, {}};
  for (const kg_core::Event& event : mission.events) {
    rules.event_capacity[event.iri] = event.capacity;
  }
  return rules;
}

template <typename T, typename Predicate>
const T* FindIf(const std::vector<T>& values, Predicate is_it) {
  for (const T& value : values) {
    if (is_it(value)) return &value;
  }
  return nullptr;
}

// One compilation on the way.
class Run {
 public:
  Run(const kg_core::Mission& mission, const Compilation* last,
      RasterStore* rasters, int first_window)
      : last_(last),
        rasters_(rasters),
        now_(std::make_shared<Compilation>()),
        clock_(&now_->stage_seconds) {
    now_->mission = mission;
    now_->first_window = first_window;
  }

  std::shared_ptr<const Compilation> Compile(std::uint64_t world_version) {
    now_->world_version = world_version;
    for (const TimeWindow& window : Windows()) AddField(window.index);
    clock_.End("fields");
    for (const Agent& agent : now_->mission.agents) AddTensors(agent);
    for (const Agent& agent : now_->mission.agents) AddRules(agent);
    now_->coordination = Coordinate(now_->mission);
    if (!last_ || !Same(last_->coordination, now_->coordination)) {
      now_->dirty.push_back({"coordination", "", -1});
    }
    clock_.End("rules");
    return now_;
  }

 private:
  std::vector<TimeWindow> Windows() const {
    std::vector<TimeWindow> windows;
    for (const TimeWindow& window : now_->mission.windows) {
      if (window.index >= now_->first_window) windows.push_back(window);
    }
    return windows;
  }

  void AddField(int window) {
    now_->fields.push_back(rasters_->Field(now_->mission, window));
    const WorkField& field = *now_->fields.back();
    const auto same = [&](const std::shared_ptr<const WorkField>& other) {
      return other->window == window && other->hash == field.hash;
    };
    if (last_ && FindIf(last_->fields, same)) return;
    now_->dirty.push_back({"work_field", "", window});
  }

  std::optional<HorizonScale> Horizon(const Agent& agent) {
    if (agent.policy.confidence_mode != kg_core::ConfidenceMode::kHorizon) {
      return std::nullopt;
    }
    std::vector<WindowRasters> all;
    for (const TimeWindow& window : now_->mission.windows) {
      const auto field = rasters_->Field(now_->mission, window.index);
      all.push_back(*rasters_->Rasters(now_->mission, agent.policy, *field));
    }
    return MeasureHorizon(now_->mission, agent, all);
  }

  void AddTensors(const Agent& agent) {
    const std::optional<HorizonScale> horizon = Horizon(agent);
    const std::vector<TimeWindow> windows = Windows();
    for (std::size_t i = 0; i < windows.size(); ++i) {
      clock_.End("tensors");
      const auto rasters =
          rasters_->Rasters(now_->mission, agent.policy, *now_->fields[i]);
      clock_.End("read");
      now_->tensors.push_back(
          Tensor(agent, windows[i], *rasters, horizon ? &*horizon : nullptr));
      now_->rasters.push_back(rasters);
      NoteTensor(*now_->tensors.back());
    }
    if (horizon) now_->horizons[agent.iri] = *horizon;
    clock_.End("tensors");
  }

  // Made anew only if neither this compilation nor the last one has its hash.
  std::shared_ptr<const MissionTensor> Tensor(const Agent& agent,
                                              const TimeWindow& window,
                                              const WindowRasters& rasters,
                                              const HorizonScale* horizon) {
    const std::string hash =
        TensorHash(now_->mission, agent, window, rasters, horizon);
    const std::shared_ptr<const MissionTensor> same = FindTensor(hash, agent);
    if (!same) {
      return std::make_shared<MissionTensor>(
          CompileTensor(now_->mission, agent, window, rasters, horizon));
    }
    std::vector<std::string> sources =
        horizon ? horizon->derived_from
                : TensorSources(now_->mission, agent, window, rasters);
    if (same->agent_iri == agent.iri && same->window == window.index &&
        same->derived_from == sources) {
      return same;
    }
    auto copy = std::make_shared<MissionTensor>(*same);
    copy->agent_iri = agent.iri;
    copy->window = window.index;
    copy->derived_from = std::move(sources);
    return copy;
  }

  // The agent's own first: it needs no copy.
  std::shared_ptr<const MissionTensor> FindTensor(const std::string& hash,
                                                  const Agent& agent) const {
    using Pointer = std::shared_ptr<const MissionTensor>;
    const auto own = [&](const Pointer& tensor) {
      return tensor->hash == hash && tensor->agent_iri == agent.iri;
    };
    const auto any = [&](const Pointer& tensor) {
      return tensor->hash == hash;
    };
    const Pointer* found = last_ ? FindIf(last_->tensors, own) : nullptr;
    if (!found) found = FindIf(now_->tensors, any);
    if (!found && last_) found = FindIf(last_->tensors, any);
    return found ? *found : nullptr;
  }

  void NoteTensor(const MissionTensor& tensor) {
    const auto same = [&](const std::shared_ptr<const MissionTensor>& other) {
      return other->agent_iri == tensor.agent_iri &&
             other->window == tensor.window && other->hash == tensor.hash;
    };
    if (last_ && FindIf(last_->tensors, same)) return;
    now_->dirty.push_back({"tensor", tensor.agent_iri, tensor.window});
  }

  void AddRules(const Agent& agent) {
    SeamRules rules =
        CompileSeamRules(now_->mission, agent, now_->first_window);
    rules.world_version = now_->world_version;
    const std::size_t first = now_->rules.size() * rules.windows.size();
    for (std::size_t i = 0; i < rules.windows.size(); ++i) {
      rules.windows[i].tensor_hash = now_->tensors[first + i]->hash;
      rules.windows[i].field_hash = now_->fields[i]->hash;
    }
    NoteRules(rules);
    now_->rules.push_back(std::move(rules));
  }

  void NoteRules(const SeamRules& rules) {
    const auto is_its = [&](const SeamRules& other) {
      return other.agent_iri == rules.agent_iri;
    };
    const SeamRules* last = last_ ? FindIf(last_->rules, is_its) : nullptr;
    if (!last || !SameButForWindows(*last, rules)) {
      now_->dirty.push_back({"seam_rules", rules.agent_iri, -1});
      return;
    }
    for (std::size_t i = 0; i < rules.windows.size(); ++i) {
      if (last->windows[i] == rules.windows[i]) continue;
      now_->dirty.push_back(
          {"seam_rules", rules.agent_iri, rules.windows[i].window});
    }
  }

  const Compilation* last_;
  RasterStore* rasters_;
  std::shared_ptr<Compilation> now_;
  StageClock clock_;
};

}  // namespace

bool operator==(const DirtyArtifact& a, const DirtyArtifact& b) {
  return std::tie(a.kind, a.agent, a.window) ==
         std::tie(b.kind, b.agent, b.window);
}

MissionCompiler::MissionCompiler(kg_core::FileCache* files)
    : rasters_(ReadersOf(files)) {}

MissionCompiler::MissionCompiler(RasterReaders readers)
    : rasters_(std::move(readers)) {}

std::shared_ptr<const Compilation> MissionCompiler::Compile(
    const kg_core::Mission& mission, std::uint64_t world_version,
    int first_window) {
  Run run(mission, last_.get(), &rasters_, first_window);
  last_ = run.Compile(world_version);
  rasters_.ForgetUnused();
  return last_;
}

}  // namespace kg_compiler
