#include "kg_selector/paths/path_rules.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/team/plan_team.h"
#include "kg_selector/testing/random_team.h"

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
    for (std::size_t i = 0; i < stage.seams.size(); ++i) {
      EXPECT_EQ(stage.more_resources[0][i], stage.seams[i].to + 1.5);
    }
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
            "no path within 12.3 Wh: the cheapest takes 15.1 Wh");
  found.above_limits = {0.008 * 3600, INFINITY};
  EXPECT_EQ(BudgetNote(rules, found),
            "no path within 12.34 Wh: the cheapest takes 12.35 Wh");
  found.above_limits = {INFINITY, 1800};
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

int Difference(const kg_planner::Path& a, const kg_planner::Path& b) {
  int count = 0;
  for (std::size_t s = 0; s < a.nodes.size(); ++s) {
    count += a.nodes[s] != b.nodes[s];
  }
  return count;
}

TEST(PathRulesTest, DiversePathsDifferAsTheRulesSayAndTheBestIsTheFirst) {
  int alike = 0, several = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    RandomTeam random({}, seed);
    TeamMember member = random.MakeMembers().at(0);
    const auto trellis = ToTrellis(member.rules, member.graphs);
    const auto best = ChoosePaths(member.rules, trellis, {}).paths;
    member.rules.diverse = true;
    member.rules.minimum_difference = 2;
    const auto diverse = ChoosePaths(member.rules, trellis, {}).paths;
    ASSERT_EQ(best.empty(), diverse.empty());
    if (best.empty()) continue;
    EXPECT_NEAR(best[0].score(), diverse[0].score(), 1e-9);
    for (std::size_t i = 0; i < diverse.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(Difference(diverse[i], diverse[j]), 2);
      }
    }
    for (std::size_t i = 1; i < best.size(); ++i) {
      alike += Difference(best[0], best[i]) < 2;
    }
    several += diverse.size() > 1;
  }
  EXPECT_GT(alike, 25);  // The K best paths are less diverse.
  EXPECT_GT(several, 25);
}

TEST(PathRulesTest, ABudgetOfHazardIsKeptOverTheHorizonAndSaysByHowMuch) {
  int changed = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    RandomTeam random({}, seed);
    TeamMember member = random.MakeMembers().at(0);
    member.rules.energy_budget_j = INFINITY;
    for (std::size_t s = 0; s < member.graphs.size(); ++s) {
      kg_compiler::NavGraph graph = member.graphs[s];
      for (auto& edge : graph.edges) {
        edge.flight.hazard_s = random.Number(0.0, 3600.0);
      }
      member.graphs.Replace(s, graph);
    }
    const AgentOffer free = PlanPriced({}, member, {});
    if (free.pathlets.empty()) continue;
    const auto hazard_s = [&](const Pathlet& path) {
      double sum_s = 0.0;
      int from = 0;
      for (std::size_t s = 0; s < path.visits.size(); ++s) {
        for (const auto& edge : member.graphs[s].edges) {
          if (edge.from == from && edge.to == path.visits[s].waypoint) {
            sum_s += edge.flight.hazard_s;
          }
        }
        from = path.visits[s].waypoint;
      }
      return sum_s;
    };
    member.rules.hazard_budget_s = 0.7 * hazard_s(free.pathlets[0]);
    const AgentOffer kept = PlanPriced({}, member, {});
    for (const Pathlet& path : kept.pathlets) {
      EXPECT_LE(hazard_s(path), member.rules.hazard_budget_s * (1 + 1e-12));
    }
    if (kept.pathlets.empty()) {
      EXPECT_NE(kept.note.find(" h of hazard: the safest takes "),
                std::string::npos)
          << kept.note;
    }
    changed += !kept.pathlets.empty();
  }
  EXPECT_GT(changed, 10);
}

TEST(PathRulesTest, AnAgentSaysByHowMuchItsEnergyIsTooLittle) {
  RandomTeam random({}, 2);
  TeamMember member = random.MakeMembers().at(0);
  member.rules.energy_budget_j = 1.0;
  const AgentOffer none = PlanPriced({}, member, {});
  ASSERT_TRUE(none.pathlets.empty());
  EXPECT_EQ(none.note.find("no path within 0.0 Wh: the cheapest takes "), 0u)
      << none.note;
}

}  // namespace
}  // namespace kg_selector
