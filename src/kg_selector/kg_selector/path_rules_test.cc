#include "kg_selector/path_rules.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_selector/masking.h"
#include "kg_selector/random_team.h"

namespace kg_selector {
namespace {

TEST(PathRulesTest, AHazardBudgetIsASecondResourceOfTheTrellis) {
  RandomTeam random({}, 1);
  TeamMember member = random.MakeMembers().at(0);
  EXPECT_TRUE(ToTrellis(member.rules, member.graphs).more_limits.empty());
  for (std::size_t s = 0; s < member.graphs.size(); ++s) {
    kg_compiler::NavGraph graph = member.graphs[s];
    for (auto& edge : graph.edges) {
      edge.flight.hazard_s = edge.to + 1.0;
      edge.isolation_s = 0.5;
    }
    member.graphs.Replace(s, graph);
  }
  member.rules.hazard_budget_s = 7.0;
  const auto trellis = ToTrellis(member.rules, member.graphs);
  EXPECT_EQ(trellis.more_limits, std::vector<double>{7.0});
  for (const kg_planner::Stage& stage : trellis.stages) {
    ASSERT_EQ(stage.more_resources.size(), 1u);
    ASSERT_EQ(stage.more_resources[0].size(), stage.seams.size());
    for (std::size_t i = 0; i < stage.seams.size(); ++i)
      EXPECT_EQ(stage.more_resources[0][i], stage.seams[i].to + 1.5);
  }
}

TEST(PathRulesTest, ANoteSaysByHowMuchABudgetIsTooSmall) {
  kg_compiler::SeamRules rules;
  rules.energy_budget_j = 12.34 * 3600;
  rules.hazard_budget_s = 2 * 3600;
  kg_planner::KBest found;
  EXPECT_EQ(BudgetNote(rules, found), "");
  found.above_limits = {2.8 * 3600, 0.0};
  EXPECT_EQ(BudgetNote(rules, found),
            "no path within 12.3 Wh: the thriftiest takes 15.1 Wh");
  found.above_limits = {0.0, 1800};
  EXPECT_EQ(BudgetNote(rules, found),
            "no path within 2.0 h of hazard: the safest takes 2.5 h");
  found.above_limits = {0.0, 0.0};
  EXPECT_EQ(BudgetNote(rules, found), "");
}

TEST(PathRulesTest, AsManyPathsAreChosenAsTheRulesAskFor) {
  RandomTeam random({}, 2);
  TeamMember member = random.MakeMembers().at(0);
  for (const int paths : {1, 3}) {
    member.rules.candidates = paths;
    const auto best =
        ChoosePaths(member.rules, ToTrellis(member.rules, member.graphs), {});
    EXPECT_EQ(static_cast<int>(best.paths.size()), paths);
  }
}

}  // namespace
}  // namespace kg_selector
