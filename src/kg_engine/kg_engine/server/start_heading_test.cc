// Price of the turn at the start (ex:lambda_turn): from the heading in the
// facts or in an agent's report to the plan's first waypoint and its
// explanation.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/units.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_selector/explain/explain_plan.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_engine {
namespace {

constexpr kg_base::LonLat kStart = {-90.9, 25.7};  // As in kTestMission.

class StartHeadingTest : public testing::Test {
 protected:
  StartHeadingTest() : server_(StartTestServer(folder_)) {
    team_ = std::make_unique<MissionPlanning>(server_.get());
    // Otherwise staying at the event beside the start costs no turn.
    Set("ex:bloom", "ex:forWindow", "ex:w1");
  }

  void Set(const char* subject, const char* property, const char* value) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.set = {{subject, property, value}};
    const Decision decision = server_->Apply(update);
    ASSERT_TRUE(decision.accepted) << decision.reasons.at(0);
  }

  // First visit of alpha in a new plan.
  kg_selector::Visit FirstVisit() {
    const kg_selector::CommittedPlan& plan = team_->Plan();
    return plan.assignments.at(0).pathlet.visits.at(0);
  }
  kg_selector::Visit FirstVisitHeading(const char* heading_deg) {
    Set("ex:alpha_start", "ex:headingDeg", heading_deg);
    return FirstVisit();
  }

  auto Rows(const char* query) const {
    return kg_core::RunQuery(*server_->Read(), query,
                             kg_core::DefaultDataset(std::nullopt), {})
        .rows;
  }

  kg_selector::PlannedWorld World() const {
    kg_selector::PlannedWorld world;
    world.view = server_->Read();
    world.compilation =
        std::make_shared<const kg_compiler::Compilation>(team_->compilation());
    kg_selector::PlannedMission planned =
        kg_selector::PlanMission(*world.compilation, nullptr);
    world.rules = kg_selector::ToTeamRules(*world.compilation);
    world.members = std::move(planned.members);
    world.plan = std::move(planned.plan);
    world.has_plan = true;
    kg_selector::NameAgentsByIri(&world);
    return world;
  }

  kg_base::TemporaryFolder folder_;
  std::unique_ptr<MissionServer> server_;
  std::unique_ptr<MissionPlanning> team_;
};

TEST_F(StartHeadingTest, ChangesNoPlanWithoutAPrice) {
  const kg_selector::Visit east = FirstVisitHeading("90");
  const kg_selector::Visit west = FirstVisitHeading("270");
  EXPECT_TRUE(east == west);
  EXPECT_EQ(east.cost.turn_rad, 0.0);
}

TEST_F(StartHeadingTest, ChangesTheFirstWaypointIfTurnsAreDear) {
  Set("ex:fast", "ex:lambda_turn", "1000");
  const kg_selector::Visit east = FirstVisitHeading("90");
  const kg_selector::Visit west = FirstVisitHeading("270");
  EXPECT_GT(east.position.lon_deg, kStart.lon_deg + 0.05);
  EXPECT_LT(west.position.lon_deg, kStart.lon_deg - 0.05);
  for (const kg_selector::Visit& visit : {east, west}) {
    EXPECT_LT(visit.cost.turn_rad, kg_base::kPi / 2.0);
    EXPECT_NEAR(visit.cost.seam_cost, 1000.0 * visit.cost.turn_rad, 1e-6);
  }
}

TEST_F(StartHeadingTest, LeavesTheTurnInTheFactsOfPlanAndGraph) {
  const char* const turns =
      "SELECT * { GRAPH ?g { ?cost ex:forAgent ex:alpha ; ex:costTurn ?turn } "
      "}";
  FirstVisitHeading("90");
  EXPECT_TRUE(Rows(turns).empty());
  Set("ex:fast", "ex:lambda_turn", "1000");
  const kg_selector::Visit visit = FirstVisitHeading("100");
  ASSERT_GT(visit.cost.turn_rad, 0.0);
  const auto rows = Rows(
      "SELECT ?turn { GRAPH ?g { ?step a ex:Assignment ; ex:costTurn ?turn } "
      "}");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(std::stod(rows[0][0]->text), visit.cost.turn_rad, 1e-9);
  EXPECT_GT(Rows(turns).size(), 1u);  // Edges of the graph, too.
}

TEST_F(StartHeadingTest, IsThatOfTheNewestReportOnceTheMissionRuns) {
  Set("ex:fast", "ex:lambda_turn", "1000");
  ASSERT_GT(FirstVisitHeading("90").position.lon_deg, kStart.lon_deg);
  const double time_s = server_->mission().windows.at(0).begin_s + 60.0;
  ASSERT_TRUE(server_->Observe("alpha", {kStart, 1.5 * kg_base::kPi, time_s}));
  EXPECT_LT(FirstVisit().position.lon_deg, kStart.lon_deg);
}

TEST_F(StartHeadingTest, IsCitedInTheExplanationOfTheFirstStep) {
  Set("ex:fast", "ex:lambda_turn", "2");
  const kg_selector::Visit first = FirstVisitHeading("180");
  kg_selector::PlanQuestion question;
  question.agent = "alpha";
  question.window = 0;
  const kg_compiler::Explanation step = kg_selector::Explain(World(), question);
  EXPECT_NEAR(step.Sum(), step.value, 1e-9);
  int turns = 0;
  for (const kg_compiler::Contribution& part : step.parts) {
    if (part.term != "-lambda_turn * T") continue;
    ++turns;
    EXPECT_NEAR(part.value, -2.0 * first.cost.turn_rad, 1e-9);
    std::string facts;
    for (const std::string& fact : part.facts) facts += fact + "\n";
    EXPECT_NE(facts.find("lambda_turn"), std::string::npos) << facts;
    EXPECT_NE(facts.find("headingDeg"), std::string::npos) << facts;
    EXPECT_NE(part.text.find("180 degrees"), std::string::npos) << part.text;
  }
  EXPECT_EQ(turns, 1);
  question.window = -1;  // The whole path.
  const kg_compiler::Explanation path = kg_selector::Explain(World(), question);
  EXPECT_NEAR(path.Sum(), path.value, 1e-9);
  EXPECT_TRUE(std::any_of(path.parts.begin(), path.parts.end(),
                          [](const kg_compiler::Contribution& part) {
                            return part.text.find("window 0: turn") !=
                                       std::string::npos &&
                                   part.value < 0.0;
                          }));
}

}  // namespace
}  // namespace kg_engine
