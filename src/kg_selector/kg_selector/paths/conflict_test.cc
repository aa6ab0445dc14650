#include "kg_selector/paths/conflict.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_base/geo/geodesy.h"

namespace kg_selector {
namespace {

using kg_base::LonLat;

constexpr double kWindow_s = 1000.0;
const LonLat kPort = {-90.0, 25.0};

LonLat East(double metres) {
  return kg_base::Destination(kPort, 1.5707963267948966, metres);
}

// Starts at `start`; arrives half way through every window and stays.
Pathlet Through(const std::string& agent, LonLat start,
                const std::vector<LonLat>& places) {
  Pathlet pathlet;
  pathlet.agent = agent;
  LonLat from = start;
  for (std::size_t w = 0; w < places.size(); ++w) {
    const double begin_s = static_cast<double>(w) * kWindow_s;
    pathlet.track.push_back({from, begin_s});
    pathlet.track.push_back({places[w], begin_s + 0.5 * kWindow_s});
    pathlet.track.push_back({places[w], begin_s + kWindow_s});
    pathlet.visits.push_back({static_cast<int>(w), 0, places[w], 0.0, {}});
    from = places[w];
  }
  return pathlet;
}

TeamRules RulesOf(double separation_m) {
  TeamRules rules;
  rules.separation_m = separation_m;
  for (int w = 0; w < 5; ++w) rules.window_end_s[w] = (w + 1) * kWindow_s;
  return rules;
}

TEST(FindConflictTest, NamesTheFirstWindowWhereTwoComeTooClose) {
  const Pathlet a = Through("ex:a", East(0), {East(0), East(0), East(0)});
  const Pathlet b =
      Through("ex:b", East(9000), {East(5000), East(1500), East(100)});
  const auto conflict = FindConflict(RulesOf(2000.0), {a}, b);
  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->kind, ConflictKind::kSeparation);
  EXPECT_EQ(conflict->with_agent, "ex:a");
  EXPECT_EQ(conflict->window, 1);
  EXPECT_NEAR(conflict->margin, 500.0, 1.0);
  EXPECT_FALSE(FindConflict(RulesOf(99.0), {a}, b));
}

TEST(FindConflictTest, WindowIsUnknownWithoutTheirTimes) {
  TeamRules rules = RulesOf(2000.0);
  rules.window_end_s.clear();
  const Pathlet a = Through("ex:a", East(0), {East(0), East(0)});
  const Pathlet b = Through("ex:b", East(9000), {East(5000), East(1500)});
  EXPECT_EQ(FindConflict(rules, {a}, b)->window, -1);
}

TEST(FindConflictTest, TheThresholdItselfIsFarEnough) {
  const Pathlet a = Through("ex:a", East(0), {East(0)});
  const Pathlet b = Through("ex:b", East(3000), {East(3000)});
  const double distance_m = ClosestApproach(a.track, b.track)->distance_m;
  EXPECT_FALSE(FindConflict(RulesOf(distance_m), {a}, b));
  EXPECT_TRUE(FindConflict(RulesOf(std::nextafter(distance_m, 1e9)), {a}, b));
}

TEST(FindConflictTest, WithoutSeparationOnlyTheSamePlaceIsForbidden) {
  const Pathlet a = Through("ex:a", East(0), {East(5000)});
  const Pathlet near = Through("ex:b", East(20000), {East(5001.5)});
  const Pathlet same = Through("ex:b", East(20000), {East(5000.5)});
  EXPECT_FALSE(FindConflict(RulesOf(0.0), {a}, near));
  const auto conflict = FindConflict(RulesOf(0.0), {a}, same);
  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->window, 0);
  EXPECT_NEAR(conflict->margin, 0.5, 1e-3);
}

TEST(FindConflictTest, SoftSeparationForbidsOnlyTheSamePlace) {
  TeamRules rules = RulesOf(5000.0);
  rules.separation_is_hard = false;
  const Pathlet a = Through("ex:a", East(0), {East(0)});
  EXPECT_FALSE(
      FindConflict(rules, {a}, Through("ex:b", East(100), {East(100)})));
  EXPECT_TRUE(FindConflict(rules, {a}, Through("ex:b", East(100), {East(0)})));
}

TEST(FindConflictTest, AgentsThatStartTogetherMustSeparate) {
  const Pathlet a = Through("ex:a", East(0), {East(9000), East(9000)});
  const Pathlet apart = Through("ex:b", East(0), {East(-9000), East(-9000)});
  const Pathlet stays = Through("ex:b", East(0), {East(8500), East(-9000)});
  const Pathlet later = Through("ex:b", East(0), {East(0), East(8500)});
  EXPECT_FALSE(FindConflict(RulesOf(2000.0), {a}, apart));
  EXPECT_EQ(FindConflict(RulesOf(2000.0), {a}, stays)->window, 0);
  EXPECT_EQ(FindConflict(RulesOf(2000.0), {a}, later)->window, 1);
}

TEST(FindConflictTest, SeparatedAgentsMayNotMeetInTheFirstWindow) {
  Pathlet a = Through("ex:a", East(0), {East(0)});
  Pathlet b = a;
  b.agent = "ex:b";
  b.track = {{East(0), 0.0},
             {East(9000), 300.0},
             {East(500), 600.0},
             {East(9000), kWindow_s}};
  const auto conflict = FindConflict(RulesOf(2000.0), {a}, b);
  ASSERT_TRUE(conflict);
  EXPECT_NEAR(conflict->margin, 1500.0, 1.0);
}

Pathlet Visiting(const std::string& agent, int metres,
                 const std::string& event) {
  Pathlet pathlet = Through(agent, East(metres), {East(metres), East(metres)});
  pathlet.visits[1].events.push_back(event);
  return pathlet;
}

TEST(FindConflictTest, AnEventRewardsOnlySoManyAgents) {
  TeamRules rules = RulesOf(0.0);
  rules.event_capacity["ex:e"] = 2;
  const Pathlet a = Visiting("ex:a", 0, "ex:e");
  const Pathlet b = Visiting("ex:b", 1000, "ex:e");
  const Pathlet c = Visiting("ex:c", 2000, "ex:e");
  EXPECT_FALSE(FindConflict(rules, {a}, b));
  const auto conflict = FindConflict(rules, {a, b}, c);
  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->kind, ConflictKind::kCapacity);
  EXPECT_EQ(conflict->event, "ex:e");
  EXPECT_EQ(conflict->with_agent, "ex:b");
  EXPECT_EQ(conflict->window, 1);
  EXPECT_EQ(conflict->margin, -1.0);
}

TEST(FindConflictTest, ManyVisitsOfOneAgentCountOnce) {
  TeamRules rules = RulesOf(0.0);
  rules.event_capacity["ex:e"] = 2;
  Pathlet a = Visiting("ex:a", 0, "ex:e");
  a.visits[0].events.push_back("ex:e");
  EXPECT_FALSE(FindConflict(rules, {a}, Visiting("ex:b", 1000, "ex:e")));
  EXPECT_TRUE(FullEvents(rules, {a}).empty());
}

TEST(FindConflictTest, CapacityZeroAllowsNoVisit) {
  TeamRules rules = RulesOf(0.0);
  rules.event_capacity["ex:e"] = 0;
  const auto conflict = FindConflict(rules, {}, Visiting("ex:a", 0, "ex:e"));
  ASSERT_TRUE(conflict);
  EXPECT_TRUE(conflict->with_agent.empty());
  EXPECT_EQ(FullEvents(rules, {}).count("ex:e"), 1u);
}

TEST(FindConflictTest, AnEventWithoutACapacityIsOpenToAll) {
  EXPECT_FALSE(FindConflict(RulesOf(0.0), {Visiting("ex:a", 0, "ex:e")},
                            Visiting("ex:b", 1000, "ex:e")));
}

TEST(SoftPenaltyTest, IsTheSumOfMetresMissingTimesTheWeight) {
  TeamRules rules = RulesOf(5000.0);
  rules.separation_is_hard = false;
  rules.separation_weight_per_m = 0.01;
  const Pathlet a = Through("ex:a", East(0), {East(0)});
  const Pathlet b = Through("ex:b", East(4000), {East(4000)});
  const Pathlet c = Through("ex:c", East(-9000), {East(-9000)});
  const Pathlet late = Through("ex:d", East(1000), {East(1000)});
  EXPECT_NEAR(SoftPenalty(rules, {a, b, c}, late), 0.01 * (4000.0 + 2000.0),
              0.01);
  rules.separation_is_hard = true;
  EXPECT_EQ(SoftPenalty(rules, {a, b, c}, late), 0.0);
}

TEST(ConflictTest, LinesSayWhatWhereAndWithWhom) {
  EXPECT_EQ((Conflict{ConflictKind::kSeparation, "ex:a", 3, "", 250.0}.Line()),
            "250 m too close to ex:a, window 3");
  EXPECT_EQ((Conflict{ConflictKind::kCapacity, "ex:a", 2, "ex:e", -1.0}.Line()),
            "ex:e is at capacity after ex:a, window 2");
  EXPECT_STREQ(Name(ConflictKind::kSeparation), "separation");
  EXPECT_STREQ(Name(ConflictKind::kCapacity), "capacity");
}

}  // namespace
}  // namespace kg_selector
