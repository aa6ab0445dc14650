// Facts about a run's quality: bound, gap, stability, and the prices of its
// last round.

#include "kg_engine/facts/plan_facts.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/text.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_engine/terms/plan_names.h"
#include "kg_mission/mission/testing/validate_graph.h"

namespace kg_engine {
namespace {

using Rows = std::vector<std::vector<std::string>>;

class PlanFactsTest : public testing::Test {
 protected:
  PlanFactsTest() {
    server_ = StartTestServer(folder_);
    team_ = std::make_unique<MissionPlanning>(server_.get());
    kg_core::FactUpdate join;
    join.author = "operator";
    join.turtle = kSecondAgent;
    join.set = {{"ex:mission", "ex:minimumSeparationKm", "5"}};
    if (!server_->Apply(join).accepted) throw std::runtime_error("refused");
  }

  Rows Ask(const std::string& query) const {
    const kg_core::QueryResult result = kg_core::RunQuery(
        *server_->Read(), query,
        kg_core::DefaultDataset(PlanGraph(server_->plan_run()).text), {});
    Rows rows;
    for (const auto& row : result.rows) {
      rows.emplace_back();
      for (const auto& term : row) {
        rows.back().push_back(term ? kg_core::ToTurtle(*term) : "");
      }
    }
    return rows;
  }
  // Value of a property of the current run.
  std::string Said(const std::string& property) const {
    const Rows rows =
        Ask("SELECT ?o { GRAPH ?g { <" + PlanRunNode(server_->plan_run()).text +
            "> ex:" + property + " ?o } }");
    return rows.size() == 1 ? rows[0][0] : std::to_string(rows.size());
  }
  // Records a changed plan as the next run.
  void RecordAgain(PlanRecord record) {
    ++record.plan.run;
    server_->RecordPlan(record);
    for (const auto& [key, graph] : team_->progress().graphs()) {
      server_->RecordGraph(graph, team_->progress().HashBefore(graph));
    }
  }

  kg_base::TemporaryFolder folder_;
  std::unique_ptr<MissionServer> server_;
  std::unique_ptr<MissionPlanning> team_;
};

TEST_F(PlanFactsTest, ARunSaysItsModeBoundAndGap) {
  const kg_selector::CommittedPlan& plan = team_->Plan();
  const double score = plan.reward - plan.seam_cost;
  ASSERT_GE(plan.bound, score);
  EXPECT_EQ(Said("teamMode"), "\"greedy\"");
  EXPECT_EQ(Said("rounds"), std::to_string(plan.rounds));
  EXPECT_EQ(Said("bound"), ToTurtle(kg_core::DoubleLiteral(plan.bound)));
  EXPECT_EQ(Said("gap"), ToTurtle(kg_core::DoubleLiteral((plan.bound - score) /
                                                         plan.bound)));
  EXPECT_EQ(Said("stability"), "0");  // No previous plan: omitted.
  EXPECT_EQ(Said("displacementKm"), "0");
}

TEST_F(PlanFactsTest, OmitsUnknownValues) {
  PlanRecord record;
  record.plan = team_->Plan();
  record.plan.bound = std::nan("");
  RecordAgain(record);
  EXPECT_EQ(Said("bound"), "0");
  EXPECT_EQ(Said("gap"), "0");
  record.plan.bound = -1.0;  // A relative gap is undefined.
  ++record.plan.run;
  RecordAgain(record);
  EXPECT_EQ(Said("bound"), ToTurtle(kg_core::DoubleLiteral(-1.0)));
  EXPECT_EQ(Said("gap"), "0");
}

TEST_F(PlanFactsTest, TheSecondRunSaysHowStableItIs) {
  team_->Plan();
  const kg_selector::CommittedPlan& plan = team_->Plan();
  EXPECT_EQ(plan.stability, 1.0);
  EXPECT_EQ(Said("stability"), ToTurtle(kg_core::DoubleLiteral(1.0)));
  EXPECT_EQ(Said("displacementKm"), ToTurtle(kg_core::DoubleLiteral(0.0)));
}

TEST_F(PlanFactsTest, PricesCanBeAskedForAndAreValid) {
  PlanRecord record;
  record.plan = team_->Plan();
  for (const auto& [key, graph] : team_->progress().graphs()) {
    record.nav_graphs[key] = ToStamp(*graph.graph, graph.made_s);
  }
  record.prices.resize(4);
  record.prices[0].agent = "bravo";
  record.prices[0].window = 1;
  record.prices[0].waypoint = 2;
  record.prices[0].price = 0.75;
  record.prices[1].event = "http://example.org/mission/bloom";
  record.prices[1].window = -1;
  record.prices[1].price = 1.5;
  record.prices[2].agent = "alpha";  // Price 0: no fact.
  record.cooling.resize(1);
  record.cooling[0].agent = "alpha";  // No track, but a full event.
  record.cooling[0].expires_s = 1.8e9;
  record.cooling[0].full_events = {"http://example.org/mission/bloom"};
  RecordAgain(record);
  const std::string query =
      kg_base::ReadFile("../../config/queries/cooling_and_prices.rq", 1u << 20);
  const std::string run =
      "\nVALUES ?run { <" + PlanRunNode(server_->plan_run()).text + "> }";
  const Rows rows = Ask(query + run);
  ASSERT_EQ(rows.size(), 3u);
  int waypoints = 0, events = 0, coolings = 0;
  for (const auto& row :
       rows) {  // run agent by until km event window wkt price
    if (row[8].empty()) {
      ++coolings;
      EXPECT_EQ(row[1], "\"alpha\"");
      EXPECT_EQ(row[2], "");
      EXPECT_EQ(row[5], "ex:bloom");
      EXPECT_NE(row[3].find("2027-01-15T08:00:00Z"), std::string::npos);
    } else if (row[5].empty()) {
      ++waypoints;
      EXPECT_EQ(row[1], "\"bravo\"");
      EXPECT_EQ(row[6], "1");
      EXPECT_NE(row[7].find("POINT("), std::string::npos);
      EXPECT_EQ(row[8], ToTurtle(kg_core::DoubleLiteral(0.75)));
    } else {
      ++events;
      EXPECT_EQ(row[1], "");  // For all agents.
      EXPECT_EQ(row[6], "");
      EXPECT_EQ(row[8], ToTurtle(kg_core::DoubleLiteral(1.5)));
    }
  }
  EXPECT_EQ(waypoints + 10 * events + 100 * coolings, 111);
  record.cooling.clear();  // A track is not the area of a constraint.
  ++record.plan.run;
  RecordAgain(record);
  const auto violations = kg_mission::ValidateGraph(
      *server_->Read(), PlanGraph(server_->plan_run()).text);
  EXPECT_TRUE(violations.empty()) << violations.front().Line();
}

TEST_F(PlanFactsTest, ThePricesOfTheLastRoundCount) {
  PlanProgress progress;
  progress.Begin(1);
  const auto told = [&](unsigned round, double price) {
    kg_selector::RoundRequest request;
    request.cycle = 1;
    request.run = 3;
    request.round = round;
    request.prices.resize(1);
    request.prices[0].price = price;
    progress.Take(request);
  };
  told(1, 1.0);
  told(2, 2.0);
  told(2, 2.0);
  kg_selector::RunEnd end;
  end.cycle = 1;
  end.run = 3;
  progress.Take(end);
  ASSERT_EQ(progress.prices().size(), 1u);
  EXPECT_EQ(progress.prices()[0].price, 2.0);
  told(1, 1.0);  // Late message.
  EXPECT_EQ(progress.prices()[0].price, 2.0);
  progress.Begin(2);
  EXPECT_TRUE(progress.prices().empty());
}

}  // namespace
}  // namespace kg_engine
