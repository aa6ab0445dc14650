// Churn cost (A34): from the facts over node cycles to the plan's facts, and
// across a restart.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_engine {
namespace {

// A new event close to the starts of alpha and bravo.
constexpr char kLure[] = R"ttl(
ex:lure a ex:Event ; ex:forWindow ex:w0 , ex:w1 ; ex:value 9 ; ex:capacity 1 ;
    ex:radiusKm 1 ; geo:asWKT "POINT(-90.82 25.78)"^^geo:wktLiteral .
)ttl";

class ChurnTest : public testing::Test {
 protected:
  ChurnTest() {
    folders_.mission = folder_ / "mission";
    folders_.state = folder_ / "state";
    folders_.ontology = "../kg_mission/ontology";
    WriteTestMission(folders_.mission);
    Open();
    Add(kSecondAgent);
  }

  void Open() {
    server_.reset();
    server_ = std::make_unique<MissionServer>(folders_);
    team_ = std::make_unique<MissionPlanning>(server_.get());
  }
  void Add(const std::string& turtle) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.turtle = turtle;
    Apply(update);
  }
  void Weigh(const std::string& weight) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.set = {{"ex:fast", "ex:churnWeight", weight}};
    Apply(update);
  }
  void Apply(const kg_core::FactUpdate& update) {
    const Decision decision = server_->Apply(update);
    ASSERT_TRUE(decision.accepted) << decision.reasons.at(0);
  }

  void ExpectOneProcessPlans(const kg_selector::CommittedPlan& plan) const {
    const kg_selector::CommittedPlan same = kg_selector::ToCommittedPlan(
        kg_selector::PlanMission(team_->compilation(), nullptr));
    EXPECT_NEAR(same.seam_cost, plan.seam_cost, 1e-9);
    ASSERT_EQ(same.assignments.size(), plan.assignments.size());
    for (std::size_t i = 0; i < plan.assignments.size(); ++i) {
      EXPECT_EQ(same.assignments[i].pathlet.visits,
                plan.assignments[i].pathlet.visits);
      EXPECT_EQ(same.assignments[i].pathlet.seam_cost,
                plan.assignments[i].pathlet.seam_cost);
    }
  }

  std::size_t Count(const std::string& pattern) const {
    return kg_core::RunQuery(*server_->Read(),
                             "SELECT * { GRAPH graph:prov {" + pattern + "}}",
                             kg_core::DefaultDataset(std::nullopt), {})
        .rows.size();
  }

  kg_base::TemporaryFolder folder_;
  MissionFolders folders_;
  std::unique_ptr<MissionServer> server_;
  std::unique_ptr<MissionPlanning> team_;
};

bool AnyCommitted(const kg_compiler::Compilation& compilation) {
  for (const kg_compiler::SeamRules& rules : compilation.rules) {
    for (const kg_compiler::WindowRules& window : rules.windows) {
      if (window.committed) return true;
    }
  }
  return false;
}

TEST_F(ChurnTest, WithoutAWeightThePlanGoesWhereItIsBest) {
  team_->Plan();
  Add(kLure);
  const kg_selector::CommittedPlan plan = team_->Plan();
  EXPECT_FALSE(AnyCommitted(team_->compilation()));
  EXPECT_LT(plan.stability, 1.0);
  EXPECT_GT(plan.displacement_m, 1000.0);
  EXPECT_EQ(Count("?c a ex:Commitment"), 0u);
}

TEST_F(ChurnTest, AZeroWeightIsNoWeight) {
  team_->Plan();
  Add(kLure);
  const kg_selector::CommittedPlan without = team_->Plan();
  Weigh("0");
  const kg_selector::CommittedPlan with = team_->Plan();
  ASSERT_EQ(with.assignments.size(), without.assignments.size());
  for (std::size_t i = 0; i < with.assignments.size(); ++i) {
    EXPECT_EQ(with.assignments[i].agent_iri, without.assignments[i].agent_iri);
    EXPECT_EQ(with.assignments[i].pathlet.agent,
              without.assignments[i].pathlet.agent);
    EXPECT_TRUE(kg_selector::IsSamePath(with.assignments[i].pathlet,
                                        without.assignments[i].pathlet));
  }
}

TEST_F(ChurnTest, ALargeWeightKeepsThePlanWhereItWas) {
  Weigh("1000");
  const kg_selector::CommittedPlan first = team_->Plan();
  EXPECT_FALSE(AnyCommitted(team_->compilation()));  // No previous plan.
  Add(kLure);
  const kg_selector::CommittedPlan second = team_->Plan();
  EXPECT_EQ(second.stability, 1.0);
  EXPECT_EQ(second.displacement_m, 0.0);
  EXPECT_LT(second.seam_cost, 1000.0);
  ExpectOneProcessPlans(second);
  // Rules of each agent derive from its commitment to the previous run.
  EXPECT_EQ(Count("?r a ex:SeamRules ; prov:wasDerivedFrom ?c . "
                  "?c a ex:Commitment ; prov:wasGeneratedBy ?run . "
                  "?run a ex:PlanRun ; prov:endedAtTime ?when"),
            2u);
  EXPECT_EQ(Count("?c a ex:Commitment"), 2u);
}

TEST_F(ChurnTest, WhatIsGainedIsWeighedAgainstWhatIsLeft) {
  Weigh("0.5");
  team_->Plan();
  Add(kLure);
  const kg_selector::CommittedPlan plan = team_->Plan();
  EXPECT_LT(plan.stability, 1.0);  // A reward of 9 exceeds the churn cost.
  double seams = 0.0;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
      seams += visit.cost.seam_cost;
    }
  }
  EXPECT_GT(plan.seam_cost, seams);
  EXPECT_LE(plan.seam_cost, seams + 4 * 0.5 + 1e-9);
  ExpectOneProcessPlans(plan);
}

TEST_F(ChurnTest, APlanThatIsCommittedMakesNothingDirty) {
  Weigh("1000");
  team_->Plan();
  const kg_selector::CommittedPlan again = team_->Plan();
  EXPECT_TRUE(team_->compilation().dirty.empty());
  EXPECT_TRUE(AnyCommitted(team_->compilation()));
  EXPECT_EQ(again.stability, 1.0);
}

TEST_F(ChurnTest, AWeightConcernsItsPolicysAgentsOnly) {
  kg_core::FactUpdate update;
  update.author = "operator";
  update.set = {{"ex:bravo", "ex:usesPolicy", "ex:safe"}};
  Apply(update);
  team_->Plan();
  Weigh("1000");
  team_->Plan();
  const auto& compilation = team_->compilation();
  ASSERT_EQ(compilation.dirty.size(), 1u);
  EXPECT_EQ(compilation.dirty[0].kind, "seam_rules");
  for (const kg_compiler::SeamRules& rules : compilation.rules) {
    const bool has_weight = rules.agent_id == "alpha";
    EXPECT_EQ(rules.agent_iri == compilation.dirty[0].agent, has_weight);
    EXPECT_EQ(rules.windows.at(0).committed.has_value(), has_weight);
  }
}

TEST_F(ChurnTest, CommitmentsOutliveARestart) {
  Weigh("1000");
  team_->Plan();
  const auto before = server_->BeginCycle();
  Open();
  const auto after = server_->BeginCycle();
  ASSERT_EQ(before->rules.size(), after->rules.size());
  for (std::size_t i = 0; i < before->rules.size(); ++i) {
    EXPECT_TRUE(before->rules[i].windows == after->rules[i].windows);
    for (const kg_compiler::WindowRules& window : after->rules[i].windows) {
      EXPECT_TRUE(window.committed);
    }
  }
}

}  // namespace
}  // namespace kg_engine
