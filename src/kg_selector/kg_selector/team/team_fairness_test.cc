// Cases in which fairness or soft separation changes the assignment.

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_selector/team/team_modes.h"

namespace kg_selector {
namespace {

// Stays at one of several places, 10 km apart, for one window.
Pathlet At(int place, double score, double energy_j = 0.0) {
  Pathlet pathlet;
  const kg_base::LonLat position = {-90.0 + 0.1 * place, 25.0};
  pathlet.reward = score;
  pathlet.energy_j = energy_j;
  pathlet.visits = {{0, place, position, score, {}}};
  pathlet.track = {{position, 0.0}, {position, 1000.0}};
  return pathlet;
}

using Offers = std::map<std::string, std::vector<Pathlet>>;

// Agents ignore requests and always answer with all their paths.
std::map<std::string, int> PlacesOf(const TeamRules& rules,
                                    const Offers& offers) {
  std::vector<std::string> agents;
  for (const auto& [agent, paths] : offers) agents.push_back(agent);
  const auto team = MakeCoordinator(rules, agents);
  while (!team->Advance()) {
    const std::set<std::string> waiting = team->waiting_for();
    for (const std::string& agent : waiting) {
      AgentOffer candidates;
      candidates.pathlets = offers.at(agent);
      team->Offer(agent, candidates);
    }
  }
  std::map<std::string, int> places;
  for (const Pathlet& pathlet : team->outcome().committed) {
    places[pathlet.agent] = pathlet.visits[0].waypoint;
  }
  return places;
}

using Places = std::map<std::string, int>;

TeamRules RulesOf(const std::string& mode, const std::string& fairness) {
  TeamRules rules;
  rules.mode = mode;
  rules.fairness = fairness;
  rules.window_end_s[0] = 1000.0;
  rules.gap_goal = 0.0;
  return rules;
}

class FairnessOfMode : public testing::TestWithParam<const char*> {};

// 20 + 2 has the larger sum, 18 + 3 the larger minimum.
TEST_P(FairnessOfMode, MaxMinLooksAfterTheLeast) {
  const Offers offers = {{"a", {At(1, 20.0), At(2, 18.0)}},
                         {"b", {At(1, 3.0), At(3, 2.0)}}};
  EXPECT_EQ(PlacesOf(RulesOf(GetParam(), "scarcity"), offers),
            (Places{{"a", 1}, {"b", 3}}));
  EXPECT_EQ(PlacesOf(RulesOf(GetParam(), "max_min"), offers),
            (Places{{"a", 2}, {"b", 1}}));
}

// Loads 0.9 and 0.1 for 21, or 0.5 and 0.4 for 20.
TEST_P(FairnessOfMode, BalanceEvensOutWork) {
  const Offers offers = {{"a", {At(1, 12.0, 90.0), At(2, 11.0, 50.0)}},
                         {"b", {At(3, 9.0, 10.0), At(4, 9.0, 40.0)}}};
  TeamRules rules = RulesOf(GetParam(), "balance");
  rules.energy_budget_j = {{"a", 100.0}, {"b", 100.0}};
  rules.fairness_weight = 0.0;
  EXPECT_EQ(PlacesOf(rules, offers).at("a"), 1);
  rules.fairness_weight = 10.0;
  EXPECT_EQ(PlacesOf(rules, offers), (Places{{"a", 2}, {"b", 4}}));
}

// Places are 10 km apart: at 1 per km, 12 at the next place is worth 2.
TEST_P(FairnessOfMode, SoftSeparationMovesApart) {
  for (const double far : {1.0, 3.0}) {
    TeamRules rules = RulesOf(GetParam(), "scarcity");
    rules.separation_m = 20e3;
    rules.separation_is_hard = false;
    rules.separation_weight_per_m = 1e-3;
    const Offers offers = {{"a", {At(1, 50.0)}},
                           {"b", {At(2, 12.0), At(9, far)}}};
    EXPECT_EQ(PlacesOf(rules, offers).at("b"), far > 2.0 ? 9 : 2);
  }
}

TEST_P(FairnessOfMode, AnotherFairnessIsRefused) {
  EXPECT_THROW(MakeCoordinator(RulesOf(GetParam(), "envy"), {"a"}),
               kg_base::InputError);
}

INSTANTIATE_TEST_SUITE_P(ModesWithColumns, FairnessOfMode,
                         testing::Values("auction", "priced", "exact"));

TEST(CoordinatorTest, AnotherModeIsRefused) {
  EXPECT_THROW(MakeCoordinator(RulesOf("lottery", "scarcity"), {"a"}),
               kg_base::InputError);
}

}  // namespace
}  // namespace kg_selector
