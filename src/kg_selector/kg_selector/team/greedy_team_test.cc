#include "kg_selector/team/greedy_team.h"

#include "gtest/gtest.h"

namespace kg_selector {
namespace {

// Stays at one of several places, 10 km apart, for one window.
Pathlet At(int place, double score) {
  Pathlet pathlet;
  const kg_base::LonLat position = {-90.0 + 0.1 * place, 25.0};
  pathlet.reward = score;
  pathlet.visits = {{0, place, position, score, {}}};
  pathlet.track = {{position, 0.0}, {position, 1000.0}};
  return pathlet;
}

std::vector<std::string> Agents(const std::vector<Pathlet>& committed) {
  std::vector<std::string> agents;
  for (const Pathlet& pathlet : committed) agents.push_back(pathlet.agent);
  return agents;
}

using Names = std::vector<std::string>;
using NameSet = std::set<std::string>;

// a: 10 at place 1, else 3 at place 2; b: 9 at 1, else 8 at 3; c: 7 at 3, 5
// at 4. a takes 1. b would have 9 at 1: conflict, so b plans again: 8 at 3,
// which beats c's 7 at 3; c plans again and takes 4.
TEST(GreedyTeamTest, FollowsTheHandExample) {
  GreedyTeam team({}, {"a", "b", "c"});
  EXPECT_EQ(team.waiting_for(), (NameSet{"a", "b", "c"}));
  EXPECT_FALSE(team.Advance());
  team.Offer("a", {{At(1, 10.0), At(2, 3.0)}});
  team.Offer("b", {{At(1, 9.0), At(3, 8.0)}});
  team.Offer("c", {{At(3, 7.0), At(4, 5.0)}});
  EXPECT_FALSE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), Names{"a"});
  EXPECT_EQ(team.waiting_for(), NameSet{"b"});  // c's 7 might lose to b's 8.
  team.Offer("b", {{At(3, 8.0)}});
  EXPECT_FALSE(team.Advance());
  EXPECT_EQ(team.waiting_for(), NameSet{"c"});
  team.Offer("c", {{At(4, 5.0)}});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"a", "b", "c"}));
  EXPECT_EQ(team.outcome().rounds, 3);
  ASSERT_EQ(team.outcome().rejections.size(), 2u);
  EXPECT_EQ(team.outcome().rejections[0].pathlet.agent, "b");
  EXPECT_EQ(team.outcome().rejections[0].conflict.with_agent, "a");
  EXPECT_EQ(team.outcome().rejections[0].round, 0);
  EXPECT_NE(team.outcome().rejections[0].reason.find("too close to a"),
            std::string::npos);
  EXPECT_EQ(team.outcome().rejections[1].conflict.with_agent, "b");
  EXPECT_EQ(team.outcome().rejections[1].round, 1);
  EXPECT_TRUE(team.outcome().unassigned.empty());
}

TEST(GreedyTeamTest, TakesOneRoundWithoutConflicts) {
  GreedyTeam team({}, {"a", "b", "c"});
  team.Offer("c", {{At(3, 1.0)}});
  team.Offer("a", {{At(1, 2.0)}});
  team.Offer("b", {{At(2, 3.0)}});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"b", "a", "c"}));
  EXPECT_EQ(team.outcome().rounds, 1);
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(team.outcome().committed.size(), 3u);
}

TEST(GreedyTeamTest, AnAgentAboveThoseReplanningDoesNotWait) {
  GreedyTeam team({}, {"a", "b", "c"});
  team.Offer("a", {{At(1, 10.0)}});
  team.Offer("b", {{At(1, 5.0), At(2, 4.0)}});
  team.Offer("c", {{At(3, 6.0)}});
  EXPECT_FALSE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"a", "c"}));
  EXPECT_EQ(team.waiting_for(), NameSet{"b"});
}

TEST(GreedyTeamTest, ScarcityBreaksTies) {
  for (const bool a_is_scarce : {true, false}) {
    GreedyTeam team({}, {"a", "b"});
    team.Offer("a", {{At(1, 10.0), At(2, a_is_scarce ? 1.0 : 9.0)}});
    team.Offer("b", {{At(1, 10.0), At(3, 5.0)}});
    EXPECT_FALSE(team.Advance());
    EXPECT_EQ(Agents(team.outcome().committed), Names{a_is_scarce ? "a" : "b"});
  }
}

TEST(GreedyTeamTest, AnAgentWithoutASecondChoiceIsTheScarcest) {
  GreedyTeam team({}, {"a", "b"});
  team.Offer("a", {{At(1, 10.0), At(2, -100.0)}});
  team.Offer("b", {{At(1, 10.0)}});
  team.Advance();
  EXPECT_EQ(Agents(team.outcome().committed), Names{"b"});
}

TEST(GreedyTeamTest, ASecondChoiceThatIsTakenDoesNotCount) {
  GreedyTeam team({}, {"a", "b", "c"});
  team.Offer("a", {{At(1, 10.0), At(2, 4.0)}});
  team.Offer("b", {{At(1, 10.0), At(5, 9.0), At(3, 1.0)}});
  team.Offer("c", {{At(5, 20.0)}});
  team.Advance();
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"c", "b"}));
}

TEST(GreedyTeamTest, TheIriBreaksWhatScarcityLeaves) {
  GreedyTeam team({}, {"b", "a"});
  team.Offer("b", {{At(1, 10.0), At(2, 5.0)}});
  team.Offer("a", {{At(1, 10.0), At(2, 5.0)}});
  team.Advance();
  EXPECT_EQ(Agents(team.outcome().committed), Names{"a"});
}

TEST(GreedyTeamTest, GoesOnWithoutADroppedAgent) {
  GreedyTeam team({}, {"a", "b"});
  team.Offer("a", {{At(1, 1.0)}});
  EXPECT_FALSE(team.Advance());
  team.Drop("b", "no answer in 10 s");
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), Names{"a"});
  EXPECT_EQ(team.outcome().unassigned.at("b"), "no answer in 10 s");
  team.Offer("b", {{At(2, 9.0)}});  // Too late.
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(team.outcome().committed.size(), 1u);
}

TEST(GreedyTeamTest, AnAgentMayBeDroppedWhileItPlansAgain) {
  GreedyTeam team({}, {"a", "b", "c"});
  team.Offer("a", {{At(1, 10.0)}});
  team.Offer("b", {{At(1, 9.0)}});
  team.Offer("c", {{At(2, 8.0)}});
  EXPECT_FALSE(team.Advance());
  team.Drop("b", "dead");
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"a", "c"}));
}

TEST(GreedyTeamTest, TheCommittedAreNotDroppedNorAskedAgain) {
  GreedyTeam team({}, {"a"});
  team.Offer("a", {{At(1, 10.0)}});
  EXPECT_TRUE(team.Advance());
  team.Drop("a", "dead");
  team.Offer("a", {{At(2, 99.0)}});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(team.outcome().committed[0].visits[0].waypoint, 1);
  EXPECT_TRUE(team.outcome().unassigned.empty());
}

TEST(GreedyTeamTest, ALaterOfferReplacesTheEarlier) {
  GreedyTeam team({}, {"a", "b"});
  team.Offer("a", {{At(1, 10.0)}});
  team.Offer("a", {{At(2, 7.0)}});
  team.Offer("b", {{At(1, 8.0)}});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"b", "a"}));
}

TEST(GreedyTeamTest, UnknownAgentsAreIgnored) {
  GreedyTeam team({}, {"a"});
  team.Offer("z", {{At(1, 10.0)}});
  team.Drop("y", "?");
  team.Offer("a", {{At(2, 1.0)}});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), Names{"a"});
  EXPECT_TRUE(team.outcome().unassigned.empty());
}

TEST(GreedyTeamTest, NamesAgentsWithoutAPath) {
  GreedyTeam team({}, {"a", "b", "c"});
  team.Offer("a", {{At(1, 10.0)}});
  team.Offer("b", {{At(1, 9.0)}});
  team.Offer("c", {});
  EXPECT_FALSE(team.Advance());
  EXPECT_EQ(team.outcome().unassigned.at("c"), "found no path");
  team.Offer("b", {});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(team.outcome().unassigned.at("b"),
            "found no path around those committed");
}

TEST(GreedyTeamTest, AnEmptyTeamIsFinished) {
  GreedyTeam team({}, {});
  EXPECT_TRUE(team.Advance());
}

// A planner that ignores its constraints must not block the team.
TEST(GreedyTeamTest, OutOfRoundsTheRestIsChosenFromWhatWasOffered) {
  TeamRules rules;
  rules.max_rounds = 2;
  GreedyTeam team(rules, {"a", "b", "c"});
  const std::vector<Pathlet> b = {At(1, 9.0), At(2, 8.0)};
  const std::vector<Pathlet> c = {At(1, 7.0), At(2, 6.0)};
  team.Offer("a", {{At(1, 10.0)}});
  team.Offer("b", {b});
  team.Offer("c", {c});
  EXPECT_FALSE(team.Advance());
  team.Offer("b", {b});
  team.Offer("c", {c});
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(Agents(team.outcome().committed), (Names{"a", "b"}));
  EXPECT_EQ(team.outcome().committed[1].visits[0].waypoint, 2);
  EXPECT_EQ(team.outcome().unassigned.count("c"), 1u);
  EXPECT_EQ(team.outcome().rounds, 2);
}

// Places are 10 km apart: at 1 per km, 12 at the next place is worth 2 + 5.
TEST(GreedyTeamTest, SoftSeparationMovesTheFavourite) {
  TeamRules rules;
  rules.separation_m = 20e3;
  rules.separation_is_hard = false;
  rules.separation_weight_per_m = 1e-3;
  for (const double far : {1.0, 3.0}) {
    GreedyTeam team(rules, {"a", "b"});
    team.Offer("a", {{At(1, 50.0)}});
    team.Offer("b", {{At(2, 12.0), At(9, far)}});
    EXPECT_TRUE(team.Advance());
    ASSERT_EQ(team.outcome().committed.size(), 2u);
    EXPECT_EQ(team.outcome().committed[1].visits[0].waypoint,
              far > 2.0 ? 9 : 2);
  }
}

TEST(GreedyTeamTest, CapacityIsKept) {
  TeamRules rules;
  rules.event_capacity["ex:e"] = 1;
  Pathlet first = At(1, 10.0);
  Pathlet second = At(2, 9.0);
  first.visits[0].events = second.visits[0].events = {"ex:e"};
  GreedyTeam team(rules, {"a", "b"});
  team.Offer("a", {{first}});
  team.Offer("b", {{second}});
  EXPECT_FALSE(team.Advance());
  ASSERT_EQ(team.outcome().rejections.size(), 1u);
  EXPECT_EQ(team.outcome().rejections[0].conflict.kind,
            ConflictKind::kCapacity);
  team.Offer("b", {{At(2, 4.0)}});  // Without the reward.
  EXPECT_TRUE(team.Advance());
  EXPECT_EQ(team.outcome().committed.size(), 2u);
}

}  // namespace
}  // namespace kg_selector
