#include "kg_engine/display/agent_view.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_engine {
namespace {

using kg_base::LonLat;
using kg_compiler::CellAccess;
using kg_compiler::Layer;

constexpr double kDay_s = 86400.0;
constexpr LonLat kStart = {-90.0, 0.0};
constexpr LonLat kStop = {-89.8, 0.1};

// Two windows of one agent in still water.
Scene TwoWindows() {
  auto compilation = std::make_shared<kg_compiler::Compilation>();
  kg_compiler::SeamRules rules;
  rules.agent_iri = "ex:alpha";
  rules.agent_id = "alpha";
  rules.motion = {0.5, 1.0, 1.0, 1.0, 0.0};
  rules.start = kStart;
  const kg_base::Grid grid = kg_compiler::EvenGrid(-90.5, -0.5, 0.02, 51, 51);
  const kg_base::Raster ones(grid.size(), 1.0F);
  for (int window = 0; window < 2; ++window) {
    kg_compiler::WindowRules rule;
    rule.window = window;
    rule.begin_s = kDay_s * window;
    rule.end_s = rule.begin_s + kDay_s;
    rule.base_travel_m = 0.5 * kDay_s;
    rules.windows.push_back(rule);
    kg_compiler::MissionTensor tensor;
    tensor.agent_iri = "ex:alpha";
    tensor.window = window;
    tensor.grid = grid;
    tensor.hash = "tensor " + std::to_string(window);
    tensor.content = kg_compiler::HoldLayers({{Layer::kFused, ones},
                                              {Layer::kFeasibility, ones},
                                              {Layer::kAttenuation, ones}});
    compilation->tensors.push_back(
        std::make_shared<kg_compiler::MissionTensor>(tensor));
    compilation->fields.push_back(
        std::make_shared<kg_compiler::WorkField>(kg_compiler::WorkField{
            window, "ex:field", kg_compiler::UniformFlow(grid, 0.0, 0.0),
            "field"}));
  }
  compilation->rules = {rules};
  Scene scene;
  scene.compilation = compilation;
  return scene;
}

void Plan(Scene* scene) {
  kg_selector::PathAssignment assignment;
  assignment.pathlet.agent = "alpha";
  for (int window = 0; window < 2; ++window) {
    kg_selector::Visit visit;
    visit.window = window;
    visit.position = window == 0 ? kStop : kStart;
    assignment.pathlet.visits.push_back(visit);
  }
  scene->plan.assignments = {assignment};
}

int Reached(const AgentView& view) {
  const auto work = view.WorkFrom(view.places());
  return static_cast<int>(
      std::count(work.access.begin(), work.access.end(), CellAccess::kReached));
}

TEST(AgentView, LeavesFromWhereTheAgentIsInTheFirstWindow) {
  Scene scene = TwoWindows();
  EXPECT_EQ(AgentView::Of(scene, "alpha")->places(),
            std::vector<LonLat>{kStart});
  Plan(&scene);
  scene.poses["alpha"].position = {-90.1, 0.05};
  EXPECT_EQ(AgentView::Of(scene, "alpha")->places(),
            (std::vector<LonLat>{{-90.1, 0.05}}));
}

TEST(AgentView, HasLessReachAsTheWindowPasses) {
  Scene scene = TwoWindows();
  const int all = Reached(*AgentView::Of(scene, "alpha"));
  scene.time_s = 0.5 * kDay_s;
  const int rest = Reached(*AgentView::Of(scene, "alpha"));
  EXPECT_NEAR(static_cast<double>(rest) / all, 0.25, 0.05);  // Ratio of areas.
  scene.time_s = 2.0 * kDay_s;
  EXPECT_EQ(Reached(*AgentView::Of(scene, "alpha")), 0);
}

TEST(AgentView, LeavesFromThePlannedStopInLaterWindows) {
  Scene scene = TwoWindows();
  scene.window = 1;
  scene.time_s = 0.5 * kDay_s;  // Within window 0; window 1 is complete.
  EXPECT_EQ(AgentView::Of(scene, "alpha")->places(),
            std::vector<LonLat>{kStart});
  Plan(&scene);
  const auto view = AgentView::Of(scene, "alpha");
  ASSERT_EQ(view->places().size(), 1u);
  EXPECT_NEAR(view->places()[0].lon_deg, kStop.lon_deg, 1e-9);
  EXPECT_NEAR(view->places()[0].lat_deg, kStop.lat_deg, 1e-9);
  EXPECT_EQ(view->WorkFrom(view->places()).budget_s, kDay_s);
}

TEST(AgentView, KeysAreEqualOnlyForTheSameWork) {
  Scene scene = TwoWindows();
  const std::vector<LonLat> here = {kStart}, there = {kStop};
  const std::string key = AgentView::Of(scene, "alpha")->WorkKey(here);
  EXPECT_EQ(AgentView::Of(scene, "alpha")->WorkKey(here), key);
  EXPECT_NE(AgentView::Of(scene, "alpha")->WorkKey(there), key);
  scene.time_s = 60.0;
  EXPECT_NE(AgentView::Of(scene, "alpha")->WorkKey(here), key);
  scene.time_s = 0.0;
  scene.window = 1;
  EXPECT_NE(AgentView::Of(scene, "alpha")->WorkKey(here), key);
}

TEST(AgentView, IsNotOfAnUnknownAgentOrWindow) {
  Scene scene = TwoWindows();
  EXPECT_FALSE(AgentView::Of(scene, "bravo"));
  scene.window = 2;
  EXPECT_FALSE(AgentView::Of(scene, "alpha"));
}

}  // namespace
}  // namespace kg_engine
