#include "kg_compiler/compile/mission_compiler.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kg_base/common/input_error.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

constexpr int kWindows = 5;

kg_mission::Mission TestMission() {
  kg_mission::Mission mission;
  mission.iri = "ex:mission";
  mission.files["ex:file"] = {"ex:file", "/file.nc", "sha"};
  for (int t = 0; t < kWindows; ++t) {
    const std::string name = std::to_string(t);
    mission.windows.push_back(TestWindow(t, std::exp(-0.12 * t)));
    mission.work_fields.push_back({"ex:field" + name, t, "ex:file", t, t + 1});
    mission.value_layers.push_back(
        {"ex:value" + name, t, "delta_sst", "ex:file", t + 1, t});
  }
  mission.agents = {TestAgent("alpha"), TestAgent("bravo"),
                    TestAgent("charlie")};
  for (kg_mission::Agent& agent : mission.agents) {
    agent.policy.iri = "ex:policy_of_" + agent.id;
    agent.policy.beta_poi = 0.5;
    agent.start = {-90.5, 24.5};
  }
  mission.agents[1].policy.alpha_base = 0.7;
  mission.agents[2].policy.gamma_front = 0.7;
  mission.events = {{"ex:e", {-90.5, 24.5}, 2.0, 1, 9000.0, {1, 2}}};
  return mission;
}

// Fields and values that depend only on file content and time index; counts the
// reads.
struct Files {
  RasterReaders Readers() {
    return {
        [this](const kg_mission::Mission& mission,
               const kg_mission::WorkFieldRef& ref) {
          ++fields;
          std::mt19937 rng(ref.first_time_index + Seed(mission));
          return RandomFlow(rng, EvenGrid(-91, 24, 0.04, 24, 24), 0.3, 21600,
                            86400);
        },
        [this](const kg_mission::Mission& mission,
               const kg_mission::ValueLayer& layer, const kg_base::Grid& grid) {
          ++values;
          std::mt19937 rng(layer.time_index + Seed(mission));
          return RandomRaster(rng, grid.size(), 0, 1);
        }};
  }
  static unsigned Seed(const kg_mission::Mission& mission) {
    return mission.files.at("ex:file").sha256 == "sha" ? 0 : 1000;
  }
  int fields = 0;
  int values = 0;
};

using Dirty = std::vector<DirtyArtifact>;

std::string Text(const Dirty& dirty) {
  std::string text;
  for (const DirtyArtifact& d : dirty) {
    text += d.kind + " " + d.agent + " " + std::to_string(d.window) + "\n";
  }
  return text;
}

void ExpectDirty(const Dirty& wanted, const Compilation& compilation) {
  EXPECT_EQ(Text(wanted), Text(compilation.dirty));
}

void ExpectSame(const Compilation& a, const Compilation& b) {
  ASSERT_EQ(a.tensors.size(), b.tensors.size());
  for (std::size_t i = 0; i < a.tensors.size(); ++i) {
    EXPECT_EQ(a.tensors[i]->hash, b.tensors[i]->hash);
    EXPECT_EQ(a.tensors[i]->agent_iri, b.tensors[i]->agent_iri);
    EXPECT_EQ(a.tensors[i]->window, b.tensors[i]->window);
    EXPECT_EQ(a.tensors[i]->derived_from, b.tensors[i]->derived_from);
    for (const Layer layer : {Layer::kFused, Layer::kReward, Layer::kPolicy}) {
      EXPECT_EQ(a.tensors[i]->Get(layer), b.tensors[i]->Get(layer));
    }
  }
  for (std::size_t i = 0; i < a.rules.size(); ++i) {
    EXPECT_TRUE(SameButForWindows(a.rules[i], b.rules[i]));
    EXPECT_TRUE(a.rules[i].windows == b.rules[i].windows);
  }
}

TEST(MissionCompiler, CompilesAllTheFirstTimeAndNothingTheSecond) {
  Files files;
  MissionCompiler compiler(files.Readers());
  const auto first = compiler.Compile(TestMission(), 1, 0);
  EXPECT_EQ(5u, first->fields.size());
  EXPECT_EQ(15u, first->tensors.size());
  EXPECT_EQ(5u + 15u + 3u + 1u, first->dirty.size());
  const auto second = compiler.Compile(TestMission(), 2, 0);
  ExpectDirty({}, *second);
  EXPECT_EQ(2u, second->world_version);
  EXPECT_EQ(2u, second->rules[0].world_version);
  EXPECT_EQ(first->tensors[7], second->tensors[7]);
  EXPECT_EQ(5, files.fields);
  EXPECT_EQ(5, files.values);
}

TEST(MissionCompiler, NamesAgentWindowAndHashesInItsRules) {
  Files files;
  const auto all =
      MissionCompiler(files.Readers()).Compile(TestMission(), 1, 2);
  ASSERT_EQ(9u, all->tensors.size());
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < 3; ++i) {
      const MissionTensor& tensor = *all->tensors[a * 3 + i];
      EXPECT_EQ(all->mission.agents[a].iri, tensor.agent_iri);
      EXPECT_EQ(2 + i, tensor.window);
      EXPECT_EQ(tensor.hash, all->rules[a].windows[i].tensor_hash);
      EXPECT_EQ(all->fields[i]->hash, all->rules[a].windows[i].field_hash);
    }
  }
}

TEST(MissionCompiler, RemakesOneAgentsTensorsAndRulesForItsPolicy) {
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  compiler.Compile(mission, 1, 0);
  mission.agents[1].policy.alpha_base = 0.9;
  mission.agents[1].policy.lambda_risk = 2.0;
  Dirty wanted;
  for (int t = 0; t < kWindows; ++t) {
    wanted.push_back({"tensor", "ex:bravo", t});
  }
  wanted.push_back({"seam_rules", "ex:bravo", -1});
  ExpectDirty(wanted, *compiler.Compile(mission, 2, 0));
}

TEST(MissionCompiler, RemakesTheWindowsOfAConstraintOnly) {
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  compiler.Compile(mission, 1, 0);
  mission.constraints = {AreaConstraint("ex:no",
                                        kg_mission::ConstraintKind::kNoGo,
                                        Box(-90.8, 24.2, -90.6, 24.4))};
  mission.constraints[0].windows = {3};
  mission.constraints[0].agents = {"ex:alpha", "ex:charlie"};
  ExpectDirty({{"tensor", "ex:alpha", 3},
               {"tensor", "ex:charlie", 3},
               {"seam_rules", "ex:alpha", 3},
               {"seam_rules", "ex:charlie", 3}},
              *compiler.Compile(mission, 2, 0));
}

TEST(MissionCompiler, RemakesTheWindowsOfAnEventAndItsCapacityForTheTeam) {
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  mission.agents[1].policy.beta_poi = 0.0;  // Visits it, but has no bump.
  compiler.Compile(mission, 1, 0);
  mission.events[0].value = 3.0;
  ExpectDirty({{"tensor", "ex:alpha", 1},
               {"tensor", "ex:alpha", 2},
               {"tensor", "ex:charlie", 1},
               {"tensor", "ex:charlie", 2},
               {"seam_rules", "ex:alpha", 1},
               {"seam_rules", "ex:alpha", 2},
               {"seam_rules", "ex:bravo", 1},
               {"seam_rules", "ex:bravo", 2},
               {"seam_rules", "ex:charlie", 1},
               {"seam_rules", "ex:charlie", 2}},
              *compiler.Compile(mission, 2, 0));
  mission.events[0].capacity = 2;
  ExpectDirty({{"coordination", "", -1}}, *compiler.Compile(mission, 3, 0));
}

// Only the selector's rules change; no artifact is recompiled.
TEST(MissionCompiler, ATeamChosenOtherwiseIsANewPlanOfTheSameArtifacts) {
  void (*const changes[])(kg_mission::CoordinationFacts*) = {
      [](auto* team) { team->mode = "priced"; },
      [](auto* team) { team->gap_goal = 0.5; },
      [](auto* team) { team->auction_epsilon = 0.5; },
      [](auto* team) { team->select_limit_s = 0.5; },
      [](auto* team) { team->fairness = "balance"; },
      [](auto* team) { team->fairness_weight = 0.5; }};
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  std::uint64_t version = 0;
  compiler.Compile(mission, ++version, 0);
  for (const auto change : changes) {
    change(&mission.coordination);
    const auto next = compiler.Compile(mission, ++version, 0);
    ExpectDirty({{"coordination", "", -1}}, *next);
    EXPECT_EQ(0u, next->counts.compiled);
    EXPECT_TRUE(next->coordination.facts == mission.coordination);
  }
}

TEST(MissionCompiler, WhichPathsAPolicyWantsConcernsItsAgentsOnly) {
  void (*const changes[])(kg_mission::Policy*) = {
      [](auto* policy) { policy->hazard_budget_s = 3600.0; },
      [](auto* policy) { policy->diverse_paths = true; },
      [](auto* policy) { policy->minimum_difference = 2; },
      [](auto* policy) { policy->churn_weight = 0.5; }};
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  std::uint64_t version = 0;
  compiler.Compile(mission, ++version, 0);
  for (const auto change : changes) {
    change(&mission.agents[1].policy);
    const auto next = compiler.Compile(mission, ++version, 0);
    ExpectDirty({{"seam_rules", "ex:bravo", -1}}, *next);
    EXPECT_EQ(0u, next->counts.compiled);
  }
}

TEST(MissionCompiler, RemakesWhatANewFileChanges) {
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  compiler.Compile(mission, 1, 0);
  mission.files["ex:file"].sha256 = "other";
  const auto next = compiler.Compile(mission, 2, 0);
  EXPECT_EQ(5u + 15u + 15u, next->dirty.size());  // Rules: per window.
  EXPECT_EQ(10, files.fields);
}

TEST(MissionCompiler, SharesATensorAmongAgentsThatWouldHaveTheSame) {
  Files files;
  kg_mission::Mission mission = TestMission();
  mission.agents[1].policy.alpha_base = mission.agents[0].policy.alpha_base;
  MissionCompiler compiler(files.Readers());
  const auto all = compiler.Compile(mission, 1, 0);
  EXPECT_EQ(all->tensors[0]->hash, all->tensors[kWindows]->hash);
  EXPECT_EQ("ex:bravo", all->tensors[kWindows]->agent_iri);
  const auto& sources = all->tensors[kWindows]->derived_from;
  EXPECT_EQ(1,
            std::count(sources.begin(), sources.end(), "ex:policy_of_bravo"));
  EXPECT_EQ(0,
            std::count(sources.begin(), sources.end(), "ex:policy_of_alpha"));
}

// Any sequence of changes gives the same bits as compiling from scratch, and
// artifacts that are not dirty are unchanged.
TEST(MissionCompiler, IncrementalEqualsFullCompilation) {
  std::mt19937 rng(51);
  Files files;
  MissionCompiler compiler(files.Readers());
  kg_mission::Mission mission = TestMission();
  auto last = compiler.Compile(mission, 1, 0);
  int first_window = 0;
  for (int step = 2; step < 40; ++step) {
    kg_mission::Agent& agent = mission.agents[rng() % 3];
    switch (rng() % 9) {
      case 0:
        agent.policy = mission.agents[rng() % 3].policy;
        break;
      case 1:
        agent.policy.gamma_front = Uniform(rng, 0, 1);
        break;
      case 2: {
        const double x = Uniform(rng, -91, -90.2), y = Uniform(rng, 24, 24.8);
        mission.constraints.push_back(
            AreaConstraint("ex:c" + std::to_string(step),
                           rng() % 2 ? kg_mission::ConstraintKind::kSoft
                                     : kg_mission::ConstraintKind::kNoGo,
                           Box(x, y, x + 0.1, y + 0.1)));
        mission.constraints.back().attenuation = 0.5;
        mission.constraints.back().windows = {static_cast<int>(rng() % 5)};
        break;
      }
      case 3:
        mission.constraints.clear();
        break;
      case 4:
        mission.events[0].position.lat_deg = Uniform(rng, 24, 25);
        break;
      case 5:
        mission.windows[rng() % 5].confidence = Uniform(rng, 0, 1);
        break;
      case 6:
        agent.capabilities.cruise_mps = Uniform(rng, 0.2, 1);
        break;
      case 7:
        agent.policy.confidence_mode =
            static_cast<kg_mission::ConfidenceMode>(rng() % 3);
        break;
      case 8:
        first_window = static_cast<int>(rng() % 3);
        break;
    }
    const auto next = compiler.Compile(mission, step, first_window);
    ExpectSame(
        *MissionCompiler(files.Readers()).Compile(mission, step, first_window),
        *next);
    for (const auto& tensor : next->tensors) {
      const DirtyArtifact entry{"tensor", tensor->agent_iri, tensor->window};
      if (std::count(next->dirty.begin(), next->dirty.end(), entry)) continue;
      const auto same = std::find_if(
          last->tensors.begin(), last->tensors.end(), [&](const auto& old) {
            return old->agent_iri == tensor->agent_iri &&
                   old->window == tensor->window;
          });
      ASSERT_NE(last->tensors.end(), same);
      EXPECT_EQ((*same)->Get(Layer::kFused), tensor->Get(Layer::kFused));
    }
    last = next;
  }
}

std::string ErrorOf(MissionCompiler* compiler,
                    const kg_mission::Mission& mission) {
  try {
    compiler->Compile(mission, 9, 0);
  } catch (const kg_base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MissionCompiler, RefusesMissingOrDoubleLayersByNameAndGoesOnAsBefore) {
  Files files;
  MissionCompiler compiler(files.Readers());
  const kg_mission::Mission good = TestMission();
  compiler.Compile(good, 1, 0);
  kg_mission::Mission bad = good;
  bad.work_fields.erase(bad.work_fields.begin() + 3);
  EXPECT_EQ("ex:w3: no ex:WorkField ex:forWindow it", ErrorOf(&compiler, bad));
  bad = good;
  bad.agents[2].policy.value_kind = "sst";
  EXPECT_NE(std::string::npos,
            ErrorOf(&compiler, bad).find("ex:policy_of_charlie"));
  bad = good;
  bad.value_layers.push_back(bad.value_layers[1]);
  EXPECT_NE(std::string::npos, ErrorOf(&compiler, bad).find("two"));
  bad = good;
  bad.files.clear();
  EXPECT_NE(std::string::npos, ErrorOf(&compiler, bad).find("ex:file"));
  ExpectDirty({}, *compiler.Compile(good, 2, 0));
}

TEST(MissionCompiler, TakesTheNewestOfSeveralValueLayersOfAKind) {
  Files files;
  kg_mission::Mission mission = TestMission();
  kg_mission::ValueLayer newer = mission.value_layers[0];
  newer.iri = "ex:newer";
  newer.time_index = 77;
  mission.value_layers.push_back(newer);
  const auto all = MissionCompiler(files.Readers()).Compile(mission, 1, 0);
  const auto& sources = all->tensors[0]->derived_from;
  EXPECT_EQ(1, std::count(sources.begin(), sources.end(), "ex:newer"));
  EXPECT_EQ(0, std::count(sources.begin(), sources.end(), "ex:value0"));
}

}  // namespace
}  // namespace kg_compiler
