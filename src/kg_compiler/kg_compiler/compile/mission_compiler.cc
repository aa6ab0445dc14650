#include "kg_compiler/compile/mission_compiler.h"

#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "kg_base/common/parallel.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/stopwatch.h"
#include "kg_compiler/compile/dirty_box.h"

namespace kg_compiler {
namespace {

using kg_mission::Agent;
using kg_mission::TimeWindow;

// Adds the time since construction, or since the last call, to a stage.
class StageClock {
 public:
  explicit StageClock(std::map<std::string, double>* stages)
      : stages_(stages) {}
  void End(const std::string& stage) { (*stages_)[stage] += watch_.Lap_s(); }

 private:
  std::map<std::string, double>* stages_;
  kg_base::Stopwatch watch_;
};

bool Same(const CoordinationRules& a, const CoordinationRules& b) {
  return a.facts == b.facts && a.event_capacity == b.event_capacity &&
         a.event_windows == b.event_windows;
}

CoordinationRules Coordinate(const kg_mission::Mission& mission) {
  CoordinationRules rules{mission.coordination, {}, {}};
  for (const kg_mission::Event& event : mission.events) {
    rules.event_capacity[event.iri] = event.capacity;
    rules.event_windows[event.iri] = {event.windows.begin(),
                                      event.windows.end()};
  }
  return rules;
}

// Lookup tables of a compilation's artifacts.
class KnownArtifacts {
 public:
  explicit KnownArtifacts(const Compilation* compilation) : all_(compilation) {
    if (!compilation) return;
    for (const auto& field : compilation->fields) {
      fields_.insert({field->window, field->hash});
    }
    for (const Tensor& tensor : compilation->tensors) {
      const Place place(tensor->agent_iri, tensor->window);
      places_.emplace_hint(places_.end(), place, places_.size());
      by_hash_.emplace(tensor->hash, tensor);
    }
    for (const SeamRules& rules : compilation->rules) {
      rules_.emplace(rules.agent_iri, &rules);
    }
    for (const Agent& agent : compilation->mission.agents) {
      agents_.emplace(agent.iri, &agent);
    }
  }

  using Tensor = std::shared_ptr<const MissionTensor>;
  bool HasField(int window, const std::string& hash) const {
    return fields_.count({window, hash}) > 0;
  }
  // Null = there is none.
  Tensor TensorOf(const std::string& hash) const {
    return Find(by_hash_, std::string_view(hash));
  }
  Tensor TensorAt(const std::string& agent, int window) const {
    const auto found = places_.find(Place(agent, window));
    return found == places_.end() ? nullptr : all_->tensors[found->second];
  }
  const WindowRasters* RastersAt(const std::string& agent, int window) const {
    const auto found = places_.find(Place(agent, window));
    return found == places_.end() ? nullptr
                                  : all_->rasters[found->second].get();
  }
  const SeamRules* RulesOf(const std::string& agent) const {
    return Find(rules_, std::string_view(agent));
  }
  const Agent* AgentOf(const std::string& agent) const {
    return Find(agents_, std::string_view(agent));
  }

 private:
  using Place = std::pair<std::string_view, int>;
  template <typename Map, typename Key>
  static typename Map::mapped_type Find(const Map& map, const Key& key) {
    const auto found = map.find(key);
    return found == map.end() ? typename Map::mapped_type() : found->second;
  }

  const Compilation* all_;
  std::set<std::pair<int, std::string_view>> fields_;
  std::unordered_map<std::string_view, Tensor> by_hash_;
  std::map<Place, std::size_t> places_;  // Index in the compilation's tensors.
  std::map<std::string_view, const SeamRules*> rules_;
  std::map<std::string_view, const Agent*> agents_;
};

// Request of the tensor of one agent and window.
struct WantedTensor {
  const Agent* agent = nullptr;
  const TimeWindow* window = nullptr;
  std::shared_ptr<const WindowRasters> rasters;
  const HorizonScale* horizon = nullptr;
  TensorRequest request;  // Set once the horizon is known.
};

// State that a compiler keeps besides its last compilation.
struct CompilerStores {
  RasterStore* rasters;
  std::map<std::string, ValueNormaliser>* horizons;
  DataPlaneCache* cache;
};

// One compilation in progress.
class CompilationRun {
 public:
  CompilationRun(const kg_mission::Mission& mission, const Compilation* last,
                 CompilerStores stores, int first_window)
      : last_(last),
        known_(last),
        stores_(stores),
        now_(std::make_shared<Compilation>()),
        clock_(&now_->stage_seconds) {
    now_->mission = mission;
    now_->first_window = first_window;
    for (const TimeWindow& window : now_->mission.windows) {
      if (window.index >= first_window) windows_.push_back(&window);
    }
  }

  std::shared_ptr<const Compilation> Compile(std::uint64_t world_version) {
    now_->world_version = world_version;
    for (const TimeWindow* window : windows_) AddField(window->index);
    clock_.End("fields");
    ReadRasters();
    clock_.End("read");
    MeasureHorizons();
    HashTensors();
    MakeTensors();
    NameTensors();
    clock_.End("tensors");
    for (const Agent& agent : now_->mission.agents) AddRules(agent);
    now_->coordination = Coordinate(now_->mission);
    if (!last_ || !Same(last_->coordination, now_->coordination)) {
      now_->dirty.push_back({"coordination", "", -1});
    }
    clock_.End("rules");
    return now_;
  }

 private:
  void AddField(int window) {
    now_->fields.push_back(stores_.rasters->Field(now_->mission, window));
    if (known_.HasField(window, now_->fields.back()->hash)) return;
    now_->dirty.push_back({"work_field", "", window});
  }

  void ReadRasters() {
    for (const Agent& agent : now_->mission.agents) {
      for (std::size_t i = 0; i < windows_.size(); ++i) {
        now_->rasters.push_back(stores_.rasters->Rasters(
            now_->mission, agent.policy, *now_->fields[i]));
        wanted_.push_back(
            {&agent, windows_[i], now_->rasters.back(), nullptr, {}});
      }
    }
  }

  void MeasureHorizons() {
    std::map<std::string, ValueNormaliser> measured;
    for (const Agent& agent : now_->mission.agents) {
      if (agent.policy.confidence_mode ==
          kg_mission::ConfidenceMode::kHorizon) {
        now_->horizons[agent.iri] = Horizon(agent, &measured);
      }
    }
    *stores_.horizons = std::move(measured);
    for (WantedTensor& tensor : wanted_) {
      const auto horizon = now_->horizons.find(tensor.agent->iri);
      if (horizon != now_->horizons.end()) tensor.horizon = &horizon->second;
    }
  }

  // Blends all windows only if something in one of them changed.
  HorizonScale Horizon(const Agent& agent,
                       std::map<std::string, ValueNormaliser>* measured) const {
    std::vector<std::shared_ptr<const WindowRasters>> all;
    kg_base::Hasher hash;
    std::set<std::string> sources;
    for (const TimeWindow& window : now_->mission.windows) {
      const auto field = stores_.rasters->Field(now_->mission, window.index);
      all.push_back(
          stores_.rasters->Rasters(now_->mission, agent.policy, *field));
      const TensorRequest request =
          PrepareTensor({&now_->mission, &agent, &window, all.back().get()});
      hash.Add(request.hash);
      sources.insert(request.sources.begin(), request.sources.end());
    }
    // Reuse a horizon measured in this compilation or in a previous one.
    const std::string key = hash.Hex();
    for (const auto* known : {measured, stores_.horizons}) {
      const auto found = known->find(key);
      if (found == known->end()) continue;
      const ValueNormaliser scale = found->second;
      measured->emplace(key, scale);
      return {scale.low, scale.range, {sources.begin(), sources.end()}};
    }
    HorizonScale scale =
        MeasureHorizon(now_->mission, agent, all, stores_.cache);
    measured->emplace(key, ValueNormaliser{scale.low, scale.range});
    return scale;
  }

  void HashTensors() {
    kg_base::ForEachInParallel(wanted_.size(), [&](std::size_t i) {
      WantedTensor& tensor = wanted_[i];
      tensor.request =
          PrepareTensor({&now_->mission, tensor.agent, tensor.window,
                         tensor.rasters.get(), tensor.horizon, stores_.cache});
    });
  }

  // Compiles one tensor per distinct hash; reuses those of the last
  // compilation.
  void MakeTensors() {
    std::vector<const WantedTensor*> missing;
    for (const WantedTensor& tensor : wanted_) {
      const auto [made, is_new] = made_.try_emplace(tensor.request.hash);
      if (!is_new) continue;
      made->second = known_.TensorOf(tensor.request.hash);
      if (!made->second) missing.push_back(&tensor);
    }
    std::vector<KnownArtifacts::Tensor> compiled(missing.size());
    kg_base::ForEachInParallel(missing.size(), [&](std::size_t i) {
      compiled[i] = std::make_shared<const MissionTensor>(Make(*missing[i]));
    });
    for (std::size_t i = 0; i < missing.size(); ++i) {
      made_[missing[i]->request.hash] = std::move(compiled[i]);
    }
    now_->counts = {wanted_.size(), made_.size(), missing.size()};
  }

  // Compiles a tensor by updating the agent's last one for that window, if any.
  MissionTensor Make(const WantedTensor& tensor) const {
    const KnownArtifacts::Tensor last =
        known_.TensorAt(tensor.agent->iri, tensor.window->index);
    return CompilePrepared(tensor.request, last.get());
  }

  void NameTensors() {
    now_->tensors.resize(wanted_.size());
    kg_base::ForEachInParallel(wanted_.size(), [&](std::size_t i) {
      now_->tensors[i] = Named(wanted_[i]);
    });
    for (std::size_t i = 0; i < wanted_.size(); ++i) NoteTensor(wanted_[i]);
  }

  // The tensor of that hash, labelled with this agent and window; the previous
  // object if nothing changed.
  KnownArtifacts::Tensor Named(const WantedTensor& tensor) const {
    const std::string& agent = tensor.agent->iri;
    const int window = tensor.window->index;
    const std::vector<std::string>& sources = tensor.request.sources;
    const auto is_it = [&](const KnownArtifacts::Tensor& one) {
      return one && one->hash == tensor.request.hash &&
             one->agent_iri == agent && one->window == window &&
             one->derived_from == sources;
    };
    const KnownArtifacts::Tensor& made =
        made_.find(tensor.request.hash)->second;
    if (is_it(made)) return made;
    const KnownArtifacts::Tensor own = known_.TensorAt(agent, window);
    if (is_it(own)) return own;
    // Same content under another label: copying shares the content.
    auto copy = std::make_shared<MissionTensor>(*made);
    copy->agent_iri = agent;
    copy->window = window;
    copy->derived_from = sources;
    return copy;
  }

  void NoteTensor(const WantedTensor& tensor) {
    const std::string& agent = tensor.agent->iri;
    const KnownArtifacts::Tensor last =
        known_.TensorAt(agent, tensor.window->index);
    if (last && last->hash == tensor.request.hash) return;
    std::optional<CellBox> box;
    if (last) {
      const auto [known, is_new] =
          boxes_.try_emplace({last->hash, tensor.request.hash});
      if (is_new) known->second = DirtyBoxOf(tensor);
      box = known->second;
    }
    now_->dirty.push_back({"tensor", agent, tensor.window->index, box});
  }

  // Dirty box relative to the last compilation; nullopt = any cell.
  std::optional<CellBox> DirtyBoxOf(const WantedTensor& tensor) const {
    const int window = tensor.window->index;
    const Agent* agent = known_.AgentOf(tensor.agent->iri);
    const auto horizon = last_->horizons.find(agent->iri);
    return DirtyBox(
        {&last_->mission, agent, &last_->mission.windows[window],
         known_.RastersAt(agent->iri, window),
         horizon == last_->horizons.end() ? nullptr : &horizon->second},
        {&now_->mission, tensor.agent, tensor.window, tensor.rasters.get(),
         tensor.horizon});
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
    const SeamRules* last = known_.RulesOf(rules.agent_iri);
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
  KnownArtifacts known_;
  CompilerStores stores_;
  std::shared_ptr<Compilation> now_;
  StageClock clock_;
  std::vector<const TimeWindow*> windows_;  // Windows to be planned.
  std::vector<WantedTensor> wanted_;        // By agent, then window.
  // Tensors of this compilation, by hash.
  std::unordered_map<std::string_view, KnownArtifacts::Tensor> made_;
  // Dirty boxes by (old hash, new hash), shared between agents.
  std::map<std::pair<std::string_view, std::string_view>,
           std::optional<CellBox>>
      boxes_;
};

}  // namespace

bool operator==(const DirtyArtifact& a, const DirtyArtifact& b) {
  return std::tie(a.kind, a.agent, a.window) ==
         std::tie(b.kind, b.agent, b.window);
}

MissionCompiler::MissionCompiler(kg_mission::FileCache* files)
    : rasters_(ReadersOf(files)) {}

MissionCompiler::MissionCompiler(RasterReaders readers)
    : rasters_(std::move(readers)) {}

std::shared_ptr<const Compilation> MissionCompiler::Compile(
    const kg_mission::Mission& mission, std::uint64_t world_version,
    int first_window) {
  CompilationRun run(mission, last_.get(),
                     {&rasters_, &horizons_, cache_.get()}, first_window);
  last_ = run.Compile(world_version);
  rasters_.ForgetUnused();
  return last_;
}

}  // namespace kg_compiler
