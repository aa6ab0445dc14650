// For tests: random missions of three agents and three windows on a small grid
// with a current, compiled and planned in process.

#ifndef KG_SELECTOR_TESTING_PLANNED_TEST_WORLD_H_
#define KG_SELECTOR_TESTING_PLANNED_TEST_WORLD_H_

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/testing/test_world.h"
#include "kg_core/rdf/store.h"
#include "kg_selector/explain/planned_world.h"
#include "kg_selector/paths/walks.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_selector {

class PlannedTestWorld {
 public:
  explicit PlannedTestWorld(unsigned seed) : rng_(seed), seed_(seed) {
    mission.iri = "ex:mission";
    mission.files["ex:file"] = {"ex:file", "/file.nc", "sha"};
    for (int t = 0; t < 3; ++t) AddWindow(t);
    AddAgents();
    AddAreas();
    AddEvents();
    mission.coordination.separation_m = 2000.0 + 3000.0 * (seed % 3);
    mission.coordination.waypoint_spacing_m = 9000.0;
    mission.coordination.waypoints_per_window = 5;
    mission.coordination.candidates_per_agent = 4;
  }

  // Plans the current `mission`. Throws kg_base::InputError if an agent cannot
  // be planned.
  PlannedWorld Plan() {
    PlannedWorld world;
    world.view = store_.Read();
    kg_compiler::MissionCompiler compiler(Readers());
    world.compilation = compiler.Compile(mission, 1, 0);
    for (const kg_compiler::SeamRules& rules : world.compilation->rules) {
      world.members.push_back(Member(*world.compilation, rules));
    }
    world.rules = ToTeamRules(*world.compilation);
    world.plan = PlanTeam(world.rules, world.members);
    world.has_plan = true;
    NameAgentsByIri(&world);
    return world;
  }

  std::mt19937& rng() { return rng_; }
  kg_base::LonLat AnyPlace() {
    return {kg_compiler::Uniform(rng_, -90.98, -90.02),
            kg_compiler::Uniform(rng_, 24.02, 24.98)};
  }

  kg_mission::Mission mission;

 private:
  void AddWindow(int t) {
    const std::string name = std::to_string(t);
    mission.windows.push_back(kg_compiler::TestWindow(t, 1.0 - 0.2 * t));
    mission.work_fields.push_back({"ex:field" + name, t, "ex:file", t, t + 1});
    mission.value_layers.push_back(
        {"ex:value" + name, t, "delta_sst", "ex:file", t + 1, t});
  }

  void AddAgents() {
    for (const char* id : {"alpha", "bravo", "charlie"}) {
      kg_mission::Agent agent = kg_compiler::TestAgent(id);
      agent.policy.iri = std::string("ex:policy_of_") + id;
      agent.policy.beta_poi = kg_compiler::Uniform(rng_, 0.0, 0.6);
      agent.policy.gamma_front = kg_compiler::Uniform(rng_, 0.0, 0.8);
      agent.policy.lambda_time_per_s = 2e-5;
      agent.policy.lambda_energy_per_j = 5e-6;
      agent.policy.lambda_risk = 0.05;
      agent.policy.lambda_uncertainty = 0.5;
      agent.policy.soft_overrides = {{"ex:soft", 0.3}};
      agent.capabilities.cruise_mps = 0.35;
      agent.capabilities.energy_budget_j = 1e6;
      // Close together, so that their paths conflict.
      agent.start = {-90.5 + 0.05 * kg_compiler::Uniform(rng_, -1, 1) +
                         0.1 * static_cast<double>(mission.agents.size()),
                     24.5 + 0.05 * kg_compiler::Uniform(rng_, -1, 1)};
      mission.agents.push_back(agent);
    }
  }

  void AddAreas() {
    using kg_mission::ConstraintKind;
    mission.constraints = {
        kg_compiler::AreaConstraint("ex:no", ConstraintKind::kNoGo,
                                    kg_compiler::Box(-90.2, 24.1, -90.1, 24.3)),
        kg_compiler::AreaConstraint(
            "ex:soft", ConstraintKind::kSoft,
            kg_compiler::Box(-90.7, 24.5, -90.5, 24.8))};
    mission.constraints[1].attenuation = 0.6;
  }

  void AddEvents() {
    for (int i = 0; i < 4; ++i) {
      kg_mission::Event event;
      event.iri = "ex:e" + std::to_string(i);
      event.position = {kg_compiler::Uniform(rng_, -90.8, -90.25),
                        kg_compiler::Uniform(rng_, 24.3, 24.7)};
      event.value = kg_compiler::Uniform(rng_, 1.0, 6.0);
      event.radius_m = 8000.0;
      event.capacity = 1;
      event.windows = {i % 3};
      if (i == 3) event.windows = {0, 1};
      mission.events.push_back(event);
    }
  }

  kg_compiler::RasterReaders Readers() const {
    const unsigned seed = seed_;
    return {
        [seed](const kg_mission::Mission&,
               const kg_mission::WorkFieldRef& ref) {
          std::mt19937 rng(seed + ref.first_time_index);
          return kg_compiler::RandomFlow(
              rng, kg_compiler::EvenGrid(-91, 24, 0.04, 26, 26), 0.15, 21600,
              3 * 86400);
        },
        [seed](const kg_mission::Mission&, const kg_mission::ValueLayer& layer,
               const kg_base::Grid& grid) {
          std::mt19937 rng(seed + 1000 + layer.time_index);
          return kg_compiler::RandomRaster(rng, grid.size(), 0, 1);
        }};
  }

  static TeamMember Member(const kg_compiler::Compilation& compilation,
                           const kg_compiler::SeamRules& rules) {
    std::vector<kg_compiler::WindowWorld> worlds;
    for (const kg_compiler::WindowRules& window : rules.windows) {
      kg_compiler::WindowWorld world;
      for (const auto& tensor : compilation.tensors) {
        if (tensor->agent_iri == rules.agent_iri &&
            tensor->window == window.window) {
          world.tensor = tensor.get();
        }
      }
      for (const auto& field : compilation.fields) {
        if (field->window == window.window) world.field = &field->field;
      }
      worlds.push_back(world);
    }
    return {rules, CompileWalkedGraphs(rules, worlds, nullptr)};
  }

  std::mt19937 rng_;
  unsigned seed_;
  kg_core::Store store_{""};
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TESTING_PLANNED_TEST_WORLD_H_
