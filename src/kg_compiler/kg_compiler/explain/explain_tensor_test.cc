#include "kg_compiler/explain/explain_tensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kg_base/common/input_error.h"
#include "kg_compiler/control_plane/proximal_recurrence.h"
#include "kg_compiler/testing/test_world.h"
#include "kg_core/rdf/store.h"

namespace kg_compiler {
namespace {

using kg_mission::ConfidenceMode;
using kg_mission::ConstraintKind;
using kg_mission::Mission;
using kg_mission::Normalisation;

// A random mission of one agent and three windows on an uneven grid: negative
// and positive priors, events, soft zones that overlap, no-go areas, buffers.
class RandomMission {
 public:
  explicit RandomMission(unsigned seed) : rng_(seed) {
    grid_ = UnevenGrid(rng_, 14, 17);
    for (int i = 0; i < 3; ++i) AddWindow(i);
    AddConstraints();
    AddPriors();
    mission.agents = {TestAgent("alpha")};
    SetPolicy(&mission.agents[0].policy);
  }

  void SetPolicy(kg_mission::Policy* policy) {
    policy->alpha_base = Uniform(rng_, -0.2, 1.5);
    policy->gamma_front = Chance() ? 0.0 : Uniform(rng_, 0.1, 1.0);
    policy->beta_poi = Chance() ? 0.0 : Uniform(rng_, 0.1, 1.0);
    policy->beta = {{"ex:p0", Uniform(rng_, -1.5, 1.0)},
                    {"ex:p1", Uniform(rng_, -0.5, 1.0)}};
    if (Chance()) policy->soft_overrides["ex:c1"] = Uniform(rng_, 0, 0.9);
    if (rng_() % 6 == 0) mission.agents[0].must_avoid["ex:c1"] = {"ex:said"};
    policy->normalisation = static_cast<Normalisation>(rng_() % 3);
    policy->confidence_mode = static_cast<ConfidenceMode>(rng_() % 3);
  }

  TensorInputs Inputs(int window) {
    TensorInputs in{&mission, &mission.agents[0], &mission.windows[window],
                    &rasters[window], nullptr};
    if (in.agent->policy.confidence_mode == ConfidenceMode::kHorizon) {
      horizon_ = MeasureHorizon(mission, *in.agent, rasters);
      in.horizon = &horizon_;
    }
    return in;
  }
  MissionTensor Compile(const TensorInputs& in) const {
    return CompileTensor(mission, *in.agent, *in.window, *in.rasters,
                         in.horizon);
  }

  Mission mission;
  std::vector<WindowRasters> rasters;

 private:
  bool Chance() { return rng_() % 3 == 0; }
  void AddWindow(int i) {
    mission.windows.push_back(TestWindow(i, std::exp(-0.3 * i)));
    kg_base::Raster value = RandomRaster(rng_, grid_.size(), -0.5, 3.0);
    const kg_base::Mask land = RandomMask(rng_, grid_.size(), 0.15);
    for (std::size_t k = 0; k < value.size(); ++k) {
      if (land[k]) value[k] = kGap;
    }
    rasters.push_back(TestRasters(grid_, value, land));
  }
  kg_base::Geometry AnyBox() {
    const double west = Uniform(rng_, -92.0, -91.5);
    const double south = Uniform(rng_, 23.0, 23.4);
    return Box(west, south, west + Uniform(rng_, 0.05, 0.3),
               south + Uniform(rng_, 0.05, 0.3));
  }
  void AddConstraints() {
    for (int i = 0; i < 4; ++i) {
      const auto kind = i == 0 ? ConstraintKind::kNoGo : ConstraintKind::kSoft;
      mission.constraints.push_back(
          AreaConstraint("ex:c" + std::to_string(i), kind, AnyBox()));
      mission.constraints.back().attenuation = Uniform(rng_, 0.1, 1.0);
      mission.constraints.back().buffer_cells = Chance() ? 1.5 : 0.0;
    }
    kg_mission::Constraint land;
    land.iri = "ex:land";
    land.is_land = true;
    land.buffer_cells = Chance() ? 1.0 : 0.0;
    mission.constraints.push_back(land);
  }
  void AddPriors() {
    for (int i = 0; i < 2; ++i) {
      mission.priors.push_back(
          {"ex:p" + std::to_string(i), "p", AnyBox(), i * 8000.0, {}, {}});
    }
    kg_mission::Event event;
    event.iri = "ex:e";
    event.position = {-91.6, 23.3};
    event.value = 2.0;
    event.radius_m = 9000.0;
    event.windows = {0, 2};
    mission.events = {event};
  }

  std::mt19937 rng_;
  kg_base::Grid grid_;
  HorizonScale horizon_;
};

const Contribution* FindPart(const Explanation& explanation,
                             const std::string& term) {
  for (const Contribution& part : explanation.parts) {
    if (part.term == term) return &part;
  }
  return nullptr;
}

class ExplainTensor : public testing::Test {
 protected:
  kg_core::Store store_{""};
  std::shared_ptr<const kg_core::GraphView> view_ = store_.Read();
  CitedFacts facts_{*view_};
};

TEST_F(ExplainTensor, PartsSumToTheCompiledTensorAtEveryCell) {
  int closed = 0, soft = 0, modes[3] = {}, scales[3] = {};
  for (unsigned seed = 1; seed <= 60; ++seed) {
    RandomMission random(seed);
    const TensorInputs in = random.Inputs(static_cast<int>(seed % 3));
    const MissionTensor tensor = random.Compile(in);
    const kg_base::Raster fused = tensor.Get(Layer::kFused);
    const TensorExplainer explainer(in, facts_);
    for (int r = 0; r < tensor.grid.rows(); ++r) {
      for (int c = 0; c < tensor.grid.cols(); ++c) {
        const Explanation cell = explainer.ExplainCell({r, c});
        const double compiled = fused[tensor.grid.Index({r, c})];
        ASSERT_NEAR(cell.value, cell.Sum(), 1e-9) << seed;
        // Tensors are computed in float32, explanations in double precision.
        ASSERT_NEAR(compiled, cell.value, 1e-6) << seed;
        for (const Contribution& part : cell.parts) {
          closed += part.term.rfind("M_hard", 0) == 0;
          soft += part.term.rfind("M_soft", 0) == 0;
        }
      }
    }
    ++modes[static_cast<int>(in.agent->policy.confidence_mode)];
    ++scales[static_cast<int>(in.agent->policy.normalisation)];
  }
  EXPECT_GT(closed, 1000);
  EXPECT_GT(soft, 1000);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT(modes[i], 5);
    EXPECT_GT(scales[i], 5);
  }
}

TEST_F(ExplainTensor, AFootprintsPartsSumToAWaypointsScore) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomMission random(seed);
    const TensorInputs in = random.Inputs(1);
    const MissionTensor tensor = random.Compile(in);
    const TensorExplainer explainer(in, facts_);
    for (const RecurrencePick& pick : ProximalRecurrence(
             tensor.grid, tensor.Get(Layer::kFused),
             kg_base::Mask(tensor.grid.size(), 1), {15e3, 9e3, 6})) {
      const Explanation sum = explainer.ExplainSum(pick.footprint);
      EXPECT_NEAR(sum.value, sum.Sum(), 1e-9);
      // The only difference is float32 rounding: 1e-6 per cell, with errors
      // that mostly cancel, hence sqrt(n).
      EXPECT_NEAR(pick.score, sum.value,
                  1e-6 * std::sqrt(static_cast<double>(pick.footprint.size())));
    }
  }
}

// If only factors of 1 follow a part, removing its fact changes U by the part.
TEST_F(ExplainTensor, ASoftZoneTakenAwayChangesUByItsContribution) {
  int checked = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    RandomMission random(seed);
    random.mission.agents[0].must_avoid.clear();
    random.mission.agents[0].policy.normalisation = Normalisation::kMax;
    const TensorInputs in = random.Inputs(0);  // w = 1.
    const TensorExplainer with(in, facts_);
    Mission& mission = random.mission;
    mission.constraints.erase(mission.constraints.begin() + 3);  // ex:c3.
    const TensorInputs less = random.Inputs(0);
    const TensorExplainer without(less, facts_);
    for (int i = 0; i < static_cast<int>(in.rasters->grid.size()); ++i) {
      const kg_base::Cell cell{i / in.rasters->grid.cols(),
                               i % in.rasters->grid.cols()};
      const Explanation a = with.ExplainCell(cell);
      const Explanation b = without.ExplainCell(cell);
      const Contribution* zone = FindPart(a, "M_soft(<ex:c3>)");
      const Contribution* base = FindPart(a, "alpha_base * B'");
      const Contribution* same = FindPart(b, "alpha_base * B'");
      const bool is_open = std::none_of(
          a.parts.begin(), a.parts.end(), [](const Contribution& part) {
            return part.term.rfind("M_hard", 0) == 0;
          });
      // Require an unchanged maximum, so that all scales are equal.
      if (!zone || !is_open || !base || base->value == 0.0 ||
          base->value != same->value) {
        continue;
      }
      EXPECT_NEAR(zone->value, a.value - b.value, 1e-9);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

TEST_F(ExplainTensor, ATermTakenAwayChangesUByItsContribution) {
  int checked = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    RandomMission random(seed);
    random.mission.constraints.clear();
    kg_mission::Policy& policy = random.mission.agents[0].policy;
    policy.alpha_base = 1.0;
    policy.beta["ex:p0"] = 0.3;
    policy.normalisation = Normalisation::kMax;
    const TensorInputs in = random.Inputs(0);
    const TensorExplainer with(in, facts_);
    policy.beta.erase("ex:p0");
    const TensorInputs less = random.Inputs(0);
    const TensorExplainer without(less, facts_);
    for (int i = 0; i < static_cast<int>(in.rasters->grid.size()); ++i) {
      if (in.rasters->land[i]) continue;
      const kg_base::Cell cell{i / in.rasters->grid.cols(),
                               i % in.rasters->grid.cols()};
      const Explanation a = with.ExplainCell(cell);
      const Explanation b = without.ExplainCell(cell);
      const Contribution* prior = FindPart(a, "beta * P(<ex:p0>)");
      const Contribution* base = FindPart(a, "alpha_base * B'");
      const Contribution* same = FindPart(b, "alpha_base * B'");
      const bool is_linear =
          !FindPart(a, "max(0, V) - V") && !FindPart(b, "max(0, V) - V");
      if (!prior || !is_linear || base->value == 0.0 ||
          base->value != same->value) {
        continue;
      }
      EXPECT_NEAR(prior->value, a.value - b.value, 1e-9);
      ++checked;
    }
  }
  EXPECT_GT(checked, 50);
}

TEST_F(ExplainTensor, NamesEveryConstraintThatForbidsACell) {
  RandomMission random(3);
  Mission& mission = random.mission;
  kg_mission::Policy& policy = mission.agents[0].policy;
  mission.agents[0].must_avoid["ex:soft"] = {"ex:said"};
  policy.soft_overrides.clear();
  const kg_base::Grid& grid = random.rasters[0].grid;
  const kg_base::Geometry all = Box(-93, 22, -90, 25);
  mission.constraints = {AreaConstraint("ex:no", ConstraintKind::kNoGo, all),
                         AreaConstraint("ex:soft", ConstraintKind::kSoft, all)};
  mission.constraints[1].attenuation = 0.4;
  const TensorInputs in = random.Inputs(0);
  const TensorExplainer explainer(in, facts_);
  for (int c = 0; c < grid.cols(); ++c) {
    const Explanation cell = explainer.ExplainCell({5, c});
    EXPECT_EQ(0.0, cell.value);
    EXPECT_NEAR(0.0, cell.Sum(), 1e-9);
    ASSERT_TRUE(FindPart(cell, "M_hard(<ex:no>)"));
    ASSERT_TRUE(FindPart(cell, "M_hard(<ex:soft>)"));
    const bool is_land = in.rasters->land[grid.Index({5, c})];
    EXPECT_EQ(is_land, FindPart(cell, "M_hard(land)") != nullptr);
  }
}

TEST_F(ExplainTensor, ReportsWindowsWithoutValue) {
  RandomMission random(5);
  kg_mission::Policy& policy = random.mission.agents[0].policy;
  policy = kg_mission::Policy();
  policy.alpha_base = -1.0;
  const TensorInputs in = random.Inputs(0);
  const Explanation cell = TensorExplainer(in, facts_).ExplainCell({3, 3});
  EXPECT_EQ(0.0, cell.value);
  EXPECT_NEAR(0.0, cell.Sum(), 1e-9);
  EXPECT_TRUE(FindPart(cell, "alpha_base * B'"));
}

TEST(Explanation, WritesNumbersThatReadBackAndFactsAsOneText) {
  Explanation explanation{0.1 + 0.2, "reward", "", {}, "Two \"parts\"."};
  explanation.parts = {{0.1, "a", {"ex:a ex:b 1", "ex:a ex:c 2"}, "first"},
                       {0.2, "b", {}, "second"}};
  EXPECT_EQ(
      "{\"value\":0.30000000000000004,\"unit\":\"reward\",\"verdict\":\"\","
      "\"text\":\"Two \\\"parts\\\".\",\"contributions\":[{\"value\":0.1,"
      "\"term\":\"a\",\"text\":\"first\",\"facts\":[\"ex:a ex:b 1\","
      "\"ex:a ex:c 2\"]},{\"value\":0.2,\"term\":\"b\",\"text\":\"second\","
      "\"facts\":[]}]}",
      ToJson(explanation));
  EXPECT_EQ("ex:a ex:b 1 . ex:a ex:c 2", JoinFacts(explanation.parts[0].facts));
  EXPECT_EQ(
      "Two \"parts\".\n   +0.100000  first\n                ex:a ex:b 1\n"
      "                ex:a ex:c 2\n   +0.200000  second",
      ToText(explanation));
}

}  // namespace
}  // namespace kg_compiler
