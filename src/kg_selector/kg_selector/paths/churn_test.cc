#include "kg_selector/paths/churn.h"

#include <algorithm>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/geo/geodesy.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/team/plan_team.h"
#include "kg_selector/team/stability.h"
#include "kg_selector/testing/random_team.h"

namespace kg_selector {
namespace {

using kg_compiler::SeamRules;

// Commits the path's end places.
void CommitTo(const Pathlet& path, SeamRules* rules) {
  for (std::size_t s = 0; s < path.visits.size(); ++s) {
    rules->windows.at(s).committed = path.visits[s].position;
  }
}

AgentOffer Plan(const TeamMember& member) {
  return PlanPriced(TeamRules(), member, {});
}

TEST(ChurnTest, CostsInProportionToTheDistanceUpToASpacing) {
  SeamRules rules;
  rules.windows.resize(2);
  rules.windows[1].window = 1;
  rules.windows[1].committed = kg_base::LonLat{-90.0, 25.0};
  rules.spacing_m = 10e3;
  rules.churn_weight = 4.0;
  const kg_base::LonLat near = {-90.05, 25.0}, far = {-91.0, 25.0};
  const double near_m = kg_base::Distance_m(near, {-90.0, 25.0});
  ASSERT_LT(near_m, 10e3);
  EXPECT_EQ(ChurnCost(rules, 1, {-90.0, 25.0}), 0.0);
  EXPECT_DOUBLE_EQ(ChurnCost(rules, 1, near), 4.0 * near_m / 10e3);
  EXPECT_EQ(ChurnCost(rules, 1, far), 4.0);
  EXPECT_EQ(ChurnCost(rules, 0, far), 0.0);  // Not committed.
  EXPECT_EQ(ChurnCost(rules, 7, far), 0.0);  // Unknown window.
  rules.churn_weight = 0.0;
  EXPECT_EQ(ChurnCost(rules, 1, far), 0.0);
}

TEST(ChurnTest, WithoutASpacingTheSensorsRadiusCounts) {
  SeamRules rules;
  rules.windows.resize(1);
  rules.windows[0].committed = kg_base::LonLat{-90.0, 25.0};
  rules.churn_weight = 1.0;
  const kg_base::LonLat other = {-90.01, 25.0};
  EXPECT_EQ(ChurnCost(rules, 0, other), 1.0);
  EXPECT_EQ(ChurnCost(rules, 0, {-90.0, 25.0}), 0.0);
  rules.sensor_radius_m = 5e3;
  EXPECT_DOUBLE_EQ(ChurnCost(rules, 0, other),
                   kg_base::Distance_m({-90.0, 25.0}, other) / 5e3);
}

TEST(ChurnTest, CommitmentsWithoutAWeightChangeNoBit) {
  int planned = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    RandomTeam random({}, seed);
    for (TeamMember& member : random.MakeMembers()) {
      const AgentOffer before = Plan(member);
      if (before.pathlets.empty()) continue;
      CommitTo(before.pathlets.back(), &member.rules);
      const AgentOffer after = Plan(member);
      ASSERT_EQ(before.pathlets.size(), after.pathlets.size());
      for (std::size_t i = 0; i < after.pathlets.size(); ++i) {
        EXPECT_EQ(before.pathlets[i].reward, after.pathlets[i].reward);
        EXPECT_EQ(before.pathlets[i].seam_cost, after.pathlets[i].seam_cost);
        EXPECT_EQ(
            ComputeStability({before.pathlets[i]}, {after.pathlets[i]}).share,
            1.0);
      }
      ++planned;
    }
  }
  EXPECT_GT(planned, 100);
}

// An agent keeps its commitments if deviating costs more than it gains; the
// cost it pays equals the score difference.
TEST(ChurnTest, ALargeWeightKeepsThePlanAndASmallOneIsPaidFor) {
  int moved = 0, kept = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    RandomTeam random({}, seed);
    for (TeamMember& member : random.MakeMembers()) {
      member.rules.spacing_m = 5e3;
      const AgentOffer free = Plan(member);
      if (free.pathlets.size() < 2) continue;
      const Pathlet& plan = free.pathlets.back();
      CommitTo(plan, &member.rules);
      for (const double weight : {0.3, 1e5}) {
        member.rules.churn_weight = weight;
        const Pathlet best = Plan(member).pathlets.at(0);
        double paid = 0.0;
        for (const Visit& visit : best.visits) {
          paid += ChurnCost(member.rules, visit.window, visit.position);
        }
        const double share = ComputeStability({plan}, {best}).share;
        if (weight > 1.0) {
          EXPECT_EQ(share, 1.0) << seed;
          EXPECT_EQ(paid, 0.0);
        }
        // At least as good as staying, at most as good as without churn.
        EXPECT_GE(best.score(), plan.score() - 1e-9);
        EXPECT_LE(best.score() + paid, free.pathlets[0].score() + 1e-9);
        ++(share < 1.0 ? moved : kept);
      }
    }
  }
  EXPECT_GT(moved, 50);
  EXPECT_GT(kept, 50);
}

TEST(ChurnTest, IsChargedOnTheWayAndLeavesRewardsAlone) {
  RandomTeam random({}, 3);
  TeamMember member = random.MakeMembers().at(0);
  member.rules.churn_weight = 2.0;
  const auto free = ToTrellis(member.rules, member.graphs);
  for (auto& window : member.rules.windows) {
    window.committed = kg_base::LonLat{-89.9, 25.1};
  }
  const auto charged = ToTrellis(member.rules, member.graphs);
  for (std::size_t s = 0; s < free.stages.size(); ++s) {
    for (std::size_t i = 0; i < free.stages[s].nodes.size(); ++i) {
      EXPECT_EQ(free.stages[s].nodes[i].reward,
                charged.stages[s].nodes[i].reward);
    }
    for (std::size_t i = 0; i < free.stages[s].seams.size(); ++i) {
      const auto& seam = free.stages[s].seams[i];
      const auto& place = member.graphs[s].waypoints.at(seam.to).position;
      EXPECT_EQ(
          charged.stages[s].seams[i].cost,
          seam.cost + ChurnCost(member.rules, static_cast<int>(s), place));
    }
  }
}

}  // namespace
}  // namespace kg_selector
