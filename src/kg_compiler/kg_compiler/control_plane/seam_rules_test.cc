#include "kg_compiler/control_plane/seam_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kg_base/common/input_error.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

kg_mission::Mission TestMission() {
  kg_mission::Mission mission;
  mission.windows = {TestWindow(0, 1.0), TestWindow(1, 0.8),
                     TestWindow(2, 0.6)};
  mission.agents = {TestAgent("alpha")};
  mission.events = {{"ex:e", {-90, 25}, 5.0, 1, 9000.0, {1, 2}}};
  mission.coordination.waypoints_per_window = 50;
  mission.coordination.waypoint_spacing_m = 8000.0;
  return mission;
}

TEST(SeamRules, AreInSiPerSecondAndJoule) {
  kg_mission::Mission mission = TestMission();
  mission.agents[0].policy.lambda_risk = 3.6;           // Per hour.
  mission.agents[0].policy.lambda_time_per_s = 0.001;   // Facts are in SI.
  mission.agents[0].policy.lambda_energy_per_j = 1e-6;  // Facts are in SI.
  mission.agents[0].policy.lambda_uncertainty = 0.25;
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_DOUBLE_EQ(0.001, rules.weights.risk_per_s);
  EXPECT_DOUBLE_EQ(0.001, rules.weights.time_per_s);
  EXPECT_DOUBLE_EQ(1e-6, rules.weights.energy_per_j);
  EXPECT_DOUBLE_EQ(0.25, rules.weights.uncertainty);
  EXPECT_DOUBLE_EQ(1e7, rules.energy_budget_j);
  EXPECT_DOUBLE_EQ(12000.0, rules.sensor_radius_m);
  EXPECT_DOUBLE_EQ(8000.0, rules.spacing_m);
}

TEST(SeamRules, TakeHazardIsolationAndModeFromTheFacts) {
  kg_mission::Mission mission = TestMission();
  mission.agents[0].policy.hazard_range_m = 1234.0;
  mission.agents[0].policy.isolation_weight = 0.25;
  mission.coordination.movement_mode = "edges";
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_EQ(1234.0, rules.hazard_range_m);
  EXPECT_EQ(0.25, rules.weights.isolation);
  EXPECT_EQ(MovementMode::kEdges, rules.movement_mode);
  mission.agents[0].policy.isolation_weight = 0.5;
  const SeamRules other = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_NE(SeamRulesHash(rules), SeamRulesHash(other));
  EXPECT_FALSE(SameButForWindows(rules, other));
  mission.coordination.movement_mode = "leaps";
  EXPECT_THROW(CompileSeamRules(mission, mission.agents[0], 0),
               kg_base::InputError);
}

TEST(SeamRules, FollowTheMobilityAndTheEnergyThatIsLeft) {
  kg_mission::Mission mission = TestMission();
  kg_mission::Agent& agent = mission.agents[0];
  const SeamRules glider = CompileSeamRules(mission, agent, 0);
  EXPECT_EQ(glider.motion.rest_mps, 0.0);
  agent.mobility = kg_mission::Mobility::kFixedWing;
  EXPECT_EQ(SeamRulesHash(CompileSeamRules(mission, agent, 0)),
            SeamRulesHash(glider));
  agent.mobility = kg_mission::Mobility::kHover;
  const SeamRules hover = CompileSeamRules(mission, agent, 0);
  EXPECT_EQ(hover.motion.rest_mps, agent.capabilities.cruise_mps);
  EXPECT_NE(SeamRulesHash(hover), SeamRulesHash(glider));
  EXPECT_FALSE(SameButForWindows(hover, glider));
  agent.start_energy_j = 5e6;
  EXPECT_EQ(CompileSeamRules(mission, agent, 0).energy_budget_j, 5e6);
  agent.start_energy_j = 5e7;  // More than the budget: no effect.
  EXPECT_EQ(CompileSeamRules(mission, agent, 0).energy_budget_j, 1e7);
}

TEST(SeamRules, TakeFieldPricesInTheOrderOfTheQuantities) {
  kg_mission::Mission mission = TestMission();
  kg_mission::Agent& agent = mission.agents[0];
  const SeamRules free = CompileSeamRules(mission, agent, 0);
  EXPECT_TRUE(free.weights.field_per_s.empty());
  agent.policy.lambda_fields["wave_height"] = 0.0;
  EXPECT_EQ(SeamRulesHash(CompileSeamRules(mission, agent, 0)),
            SeamRulesHash(free));
  agent.policy.lambda_fields["wave_height"] = 0.002;
  const SeamRules priced = CompileSeamRules(mission, agent, 0);
  EXPECT_EQ(priced.weights.field_per_s, std::vector<double>{0.002});
  EXPECT_NE(SeamRulesHash(priced), SeamRulesHash(free));
}

TEST(SeamRules, TakeThePriceOfTurnsAndHashItOnlyIfThereIsOne) {
  kg_mission::Mission mission = TestMission();
  kg_mission::Agent& agent = mission.agents[0];
  const SeamRules free = CompileSeamRules(mission, agent, 0);
  EXPECT_EQ(free.weights.turn_per_rad, 0.0);
  EXPECT_FALSE(ChargesTurns(free, free.windows[0]));
  agent.policy.lambda_turn_per_rad = 0.5;
  const SeamRules priced = CompileSeamRules(mission, agent, 0);
  EXPECT_EQ(priced.weights.turn_per_rad, 0.5);
  EXPECT_NE(SeamRulesHash(priced), SeamRulesHash(free));
  EXPECT_FALSE(SameButForWindows(priced, free));
  EXPECT_TRUE(ChargesTurns(priced, priced.windows[0]));
  EXPECT_FALSE(ChargesTurns(priced, priced.windows[1]));
  // The first window still to be planned is the one that leaves the start.
  const SeamRules later = CompileSeamRules(mission, agent, 1);
  EXPECT_TRUE(ChargesTurns(later, later.windows[0]));
}

TEST(SeamRules, TakeWhichPathsAreWantedFromThePolicy) {
  kg_mission::Mission mission = TestMission();
  kg_mission::Policy& policy = mission.agents[0].policy;
  const SeamRules plain = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_TRUE(std::isinf(plain.hazard_budget_s));
  EXPECT_FALSE(plain.diverse);
  EXPECT_EQ(1, plain.minimum_difference);
  EXPECT_EQ(0.0, plain.churn_weight);
  policy.hazard_budget_s = 5400.0;
  policy.diverse_paths = true;
  policy.minimum_difference = 3;
  policy.churn_weight = 0.25;
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_EQ(5400.0, rules.hazard_budget_s);
  EXPECT_TRUE(rules.diverse);
  EXPECT_EQ(3, rules.minimum_difference);
  EXPECT_EQ(0.25, rules.churn_weight);
}

TEST(SeamRules, ACommitmentIsPartOfAWindowAndOfTheHash) {
  const kg_mission::Mission mission = TestMission();
  const SeamRules free = CompileSeamRules(mission, mission.agents[0], 0);
  SeamRules bound = free;
  bound.windows[1].committed = kg_base::LonLat{-90.0, 25.0};
  EXPECT_FALSE(free.windows[1] == bound.windows[1]);
  EXPECT_NE(SeamRulesHash(free), SeamRulesHash(bound));
  SeamRules elsewhere = bound;
  elsewhere.windows[1].committed->lat_deg += 1e-9;
  EXPECT_NE(SeamRulesHash(bound), SeamRulesHash(elsewhere));
}

TEST(SeamRules, TravelAWindowAtCruiseSpeedUnlessAFactSaysOtherwise) {
  kg_mission::Mission mission = TestMission();
  kg_mission::Agent& agent = mission.agents[0];
  EXPECT_DOUBLE_EQ(
      0.5 * 86400,
      CompileSeamRules(mission, agent, 0).windows[0].base_travel_m);
  agent.capabilities.base_travel_m = 1234.0;
  EXPECT_DOUBLE_EQ(
      1234.0, CompileSeamRules(mission, agent, 0).windows[0].base_travel_m);
}

TEST(SeamRules, KeepAnEventToItsWindowsAndWeighItByConfidenceOnce) {
  const kg_mission::Mission mission = TestMission();
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_TRUE(rules.windows[0].events.empty());
  ASSERT_EQ(1u, rules.windows[1].events.size());
  EXPECT_DOUBLE_EQ(5.0 * 0.8, rules.windows[1].events[0].reward);
  EXPECT_DOUBLE_EQ(5.0 * 0.6, rules.windows[2].events[0].reward);
}

TEST(SeamRules, LeaveOutWindowsThatHavePassed) {
  const kg_mission::Mission mission = TestMission();
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 2);
  ASSERT_EQ(1u, rules.windows.size());
  EXPECT_EQ(2, rules.windows[0].window);
}

TEST(SeamRules, AllowAtMostTwentyWaypointsAWindow) {
  const kg_mission::Mission mission = TestMission();
  EXPECT_EQ(20, CompileSeamRules(mission, mission.agents[0], 0).max_waypoints);
}

// One change of a fact and its expected effect on the rules.
struct Change {
  const char* what;
  void (*apply)(kg_mission::Mission*);
  const char* source;  // IRI of the changed fact; empty = no effect on rules.
};

const Change kChanges[] = {
    {"cruise speed",
     [](kg_mission::Mission* m) { m->agents[0].capabilities.cruise_mps *= 2; },
     "ex:alpha_capabilities"},
    {"energy budget",
     [](kg_mission::Mission* m) {
       m->agents[0].capabilities.energy_budget_j *= 2;
     },
     "ex:alpha_capabilities"},
    {"price of risk",
     [](kg_mission::Mission* m) { m->agents[0].policy.lambda_risk += 1; },
     "ex:fast"},
    {"price of turns",
     [](kg_mission::Mission* m) {
       m->agents[0].policy.lambda_turn_per_rad = 1;
     },
     "ex:fast"},
    {"budget of risk",
     [](kg_mission::Mission* m) { m->agents[0].policy.hazard_budget_s = 60.0; },
     "ex:fast"},
    {"diverse paths",
     [](kg_mission::Mission* m) { m->agents[0].policy.diverse_paths = true; },
     "ex:fast"},
    {"least difference",
     [](kg_mission::Mission* m) { m->agents[0].policy.minimum_difference = 3; },
     "ex:fast"},
    {"price of churn",
     [](kg_mission::Mission* m) { m->agents[0].policy.churn_weight = 0.5; },
     "ex:fast"},
    {"team mode",
     [](kg_mission::Mission* m) { m->coordination.mode = "exact"; }, ""},
    {"start", [](kg_mission::Mission* m) { m->agents[0].start.lon_deg += 0.1; },
     "ex:alpha_start"},
    {"spacing",
     [](kg_mission::Mission* m) { m->coordination.waypoint_spacing_m *= 2; },
     "ex:mission"},
    {"K",
     [](kg_mission::Mission* m) { ++m->coordination.candidates_per_agent; },
     "ex:mission"},
    {"confidence",
     [](kg_mission::Mission* m) { m->windows[1].confidence = 0.7; }, "ex:w1"},
    {"end of a window",
     [](kg_mission::Mission* m) { m->windows[2].end_s -= 60; }, "ex:w2"},
    {"event's value", [](kg_mission::Mission* m) { m->events[0].value += 1; },
     "ex:e"},
    {"value of an event elsewhere",
     [](kg_mission::Mission* m) { m->events[1].value += 1; }, ""},
    {"weight of the value layer",
     [](kg_mission::Mission* m) { m->agents[0].policy.alpha_base += 1; }, ""},
    {"another agent's speed",
     [](kg_mission::Mission* m) { m->agents[1].capabilities.cruise_mps *= 2; },
     ""},
};

TEST(SeamRules, AHashChangesWithTheFactsThatAreCitedAndWithNoOthers) {
  kg_mission::Mission mission = TestMission();
  mission.iri = "ex:mission";
  mission.agents.push_back(TestAgent("bravo"));
  mission.events.push_back({"ex:none", {-90, 25}, 5.0, 1, 9000.0, {}});
  for (int i = 0; i < 3; ++i) {
    mission.windows[i].iri = "ex:w" + std::to_string(i);
  }
  kg_mission::Agent& alpha = mission.agents[0];
  alpha.iri = "ex:alpha";
  alpha.policy.iri = "ex:fast";
  alpha.capabilities.iri = "ex:alpha_capabilities";
  alpha.start_iri = "ex:alpha_start";
  const SeamRules before = CompileSeamRules(mission, alpha, 0);
  const std::vector<std::string> sources = SeamRulesSources(before);
  EXPECT_EQ(sources,
            (std::vector<std::string>{
                "ex:alpha", "ex:alpha_capabilities", "ex:alpha_start", "ex:e",
                "ex:fast", "ex:mission", "ex:w0", "ex:w1", "ex:w2"}));
  for (const Change& change : kChanges) {
    kg_mission::Mission other = mission;
    change.apply(&other);
    const SeamRules after = CompileSeamRules(other, other.agents[0], 0);
    const bool cited = change.source[0] != '\0';
    EXPECT_EQ(SeamRulesHash(before) != SeamRulesHash(after), cited)
        << change.what;
    EXPECT_EQ(std::count(sources.begin(), sources.end(), change.source),
              cited ? 1 : 0)
        << change.what;
  }
}

}  // namespace
}  // namespace kg_compiler
