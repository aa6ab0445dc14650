// The selector's rounds: cycles, late answers, dead planners.

#include "kg_engine/planning/team_selector.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"

namespace kg_engine {
namespace {

constexpr double kSeparation_m = 1000.0;

TeamTask Rules(std::uint64_t cycle) {
  TeamTask task;
  task.world_version = 3;
  task.cycle = cycle;
  task.agents = {"alpha", "bravo"};
  task.rules.energy_budget_j = {{"alpha", 1e6}, {"bravo", 1e6}};
  task.rules.mode = "greedy";
  task.rules.auction_epsilon = 0.05;
  task.rules.fairness = "scarcity";
  task.rules.separation_m = kSeparation_m;
  task.rules.separation_is_hard = true;
  task.rules.max_rounds = 5;
  return task;
}

// A path that stays at one longitude for an hour.
kg_selector::Pathlet StayAt(double lon_deg, double reward) {
  kg_selector::Pathlet pathlet;
  pathlet.reward = reward;
  pathlet.visits.resize(1);
  pathlet.visits[0].position = {lon_deg, 0.0};
  pathlet.track = {{{lon_deg, 0.0}, 1000.0}, {{lon_deg, 0.0}, 4600.0}};
  return pathlet;
}

kg_selector::AgentCandidates Offer(const std::string& agent,
                                   std::uint64_t cycle, std::uint32_t round,
                                   const kg_selector::Pathlet& best) {
  kg_selector::AgentCandidates candidates;
  candidates.agent = agent;
  candidates.agent_iri = "ex:" + agent;
  candidates.cycle = cycle;
  candidates.round = round;
  candidates.found.pathlets = {best};
  candidates.found.pathlets[0].agent = agent;
  candidates.found.proven = false;
  return candidates;
}

TEST(TeamSelectorTest, CommitsWhenAllPlannersHaveAnswered) {
  TeamSelector server;
  server.KnowRun(6);
  server.Take(Rules(1));
  EXPECT_FALSE(server.Take(Offer("alpha", 1, 0, StayAt(-90, 5))).plan);
  const SelectorAnswer answer =
      server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  ASSERT_TRUE(answer.plan);
  EXPECT_EQ(answer.plan->run, 7u);
  EXPECT_EQ(answer.plan->reward, 9.0);
  EXPECT_FALSE(answer.request);
  ASSERT_TRUE(answer.end);
  EXPECT_EQ(answer.end->run, 7u);
}

TEST(TeamSelectorTest, RequestsReplanningOfConflictingAgents) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  const SelectorAnswer asked =
      server.Take(Offer("bravo", 1, 0, StayAt(-90, 4)));
  ASSERT_FALSE(asked.plan);
  ASSERT_TRUE(asked.request);
  EXPECT_EQ(asked.request->round, 1u);
  EXPECT_EQ(asked.request->asked, std::vector<std::string>{"bravo"});
  ASSERT_EQ(asked.request->cooling.size(), 1u);
  EXPECT_EQ(asked.request->cooling[0].agent, "bravo");
  EXPECT_EQ(asked.request->cooling[0].by_agent, "alpha");
  EXPECT_EQ(asked.request->cooling[0].separation_m, kSeparation_m);
  const SelectorAnswer done = server.Take(Offer("bravo", 1, 1, StayAt(-80, 3)));
  ASSERT_TRUE(done.plan);
  EXPECT_EQ(done.plan->reward, 8.0);
  ASSERT_EQ(done.end->rejections.size(), 1u);
  const kg_selector::Conflict& lost =
      done.end->rejections[0].rejection.conflict;
  EXPECT_EQ(lost.kind, kg_selector::ConflictKind::kSeparation);
  EXPECT_EQ(lost.with_agent, "alpha");
}

TEST(TeamSelectorTest, InvalidRulesChangeNothing) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  for (const char* mode : {"lottery", ""}) {
    TeamTask bad = Rules(2);
    bad.rules.mode = mode;
    EXPECT_THROW(server.Take(bad), kg_base::InputError);
  }
  EXPECT_EQ(server.WaitingFor(), std::vector<std::string>{"bravo"});
  EXPECT_TRUE(server.Take(Offer("bravo", 1, 0, StayAt(-80, 4))).plan);
}

TEST(TeamSelectorTest, SaysHowMuchOfThePlanBeforeIsKept) {
  TeamSelector server;
  server.KnowRun(0);
  const auto plan = [&](std::uint64_t cycle, double bravo_lon_deg) {
    server.Take(Rules(cycle));
    server.Take(Offer("alpha", cycle, 0, StayAt(-90, 5)));
    return *server.Take(Offer("bravo", cycle, 0, StayAt(bravo_lon_deg, 4)))
                .plan;
  };
  const kg_selector::CommittedPlan first = plan(1, -80);
  EXPECT_TRUE(std::isnan(first.stability));
  EXPECT_TRUE(std::isnan(first.displacement_m));
  const kg_selector::CommittedPlan same = plan(2, -80);
  EXPECT_EQ(same.stability, 1.0);
  EXPECT_EQ(same.displacement_m, 0.0);
  const kg_selector::CommittedPlan moved = plan(3, -81);
  EXPECT_EQ(moved.stability, 0.5);
  EXPECT_NEAR(moved.displacement_m, 0.5 * 111.3e3, 100.0);  // On the equator.
  // Compared with the last committed plan.
  EXPECT_EQ(plan(4, -81).stability, 1.0);
}

TEST(TeamSelectorTest, APlanSaysItsModeAndBound) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  kg_selector::AgentCandidates alpha = Offer("alpha", 1, 0, StayAt(-90, 5));
  kg_selector::AgentCandidates bravo = Offer("bravo", 1, 0, StayAt(-80, 4));
  alpha.found.proven = bravo.found.proven = true;
  alpha.found.bound = 5;
  bravo.found.bound = 4;
  server.Take(alpha);
  const kg_selector::CommittedPlan plan = *server.Take(bravo).plan;
  EXPECT_EQ(plan.mode, "greedy");
  EXPECT_EQ(plan.bound, 9.0);
}

TEST(TeamSelectorTest, AnswersOfAnotherCycleAreNeverUsed) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 5)));
  EXPECT_FALSE(server.Take(Rules(2)).plan);
  EXPECT_EQ(server.WaitingFor().size(), 2u);
}

TEST(TeamSelectorTest, CandidatesMayComeBeforeTheirRules) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 5)));
  EXPECT_TRUE(server.Take(Rules(1)).plan);
}

TEST(TeamSelectorTest, DecidesNothingBeforeItKnowsTheLastRun) {
  TeamSelector server;
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 5)));
  EXPECT_FALSE(server.Take(Rules(1)).plan);
  const SelectorAnswer answer = server.KnowRun(41);
  ASSERT_TRUE(answer.plan);
  EXPECT_EQ(answer.plan->run, 42u);
}

// Otherwise the end of the run has another number than its requests.
TEST(TeamSelectorTest, ARunThatGetsAnotherNumberRepeatsItsRequestUnderIt) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  const SelectorAnswer asked =
      server.Take(Offer("bravo", 1, 0, StayAt(-90, 4)));
  ASSERT_TRUE(asked.request);
  EXPECT_EQ(asked.request->run, 1u);
  EXPECT_FALSE(server.KnowRun(0).request);
  const SelectorAnswer again = server.KnowRun(3);
  ASSERT_TRUE(again.request);
  EXPECT_EQ(again.request->run, 4u);
  EXPECT_EQ(again.request->round, 1u);
  EXPECT_EQ(again.request->time_s, asked.request->time_s);
  EXPECT_EQ(again.request->asked, asked.request->asked);
  EXPECT_EQ(again.request->cooling.size(), 1u);
  EXPECT_FALSE(server.KnowRun(3).request);
  const SelectorAnswer done = server.Take(Offer("bravo", 1, 1, StayAt(-80, 3)));
  ASSERT_TRUE(done.plan);
  EXPECT_EQ(done.plan->run, 4u);
  EXPECT_EQ(done.end->run, 4u);
  EXPECT_FALSE(server.KnowRun(5).request);  // Finished.
}

TEST(TeamSelectorTest, GoesOnWithoutTheDeadAndTakesThemBack) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  const SelectorAnswer alone = server.GiveUpWaiting();
  ASSERT_TRUE(alone.plan);
  EXPECT_EQ(alone.plan->assignments.size(), 1u);
  ASSERT_EQ(alone.plan->unassigned.size(), 1u);
  EXPECT_EQ(alone.plan->unassigned.begin()->first, "bravo");
  const SelectorAnswer both = server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  ASSERT_TRUE(both.plan);
  EXPECT_EQ(both.plan->assignments.size(), 2u);
  EXPECT_GT(both.plan->run, alone.plan->run);
}

TEST(TeamSelectorTest, DoesNotWaitForAPlannerThatDiesAgainAndAgain) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  EXPECT_FALSE(server.CountDeath("bravo").plan);
  EXPECT_EQ(server.WaitingFor(), std::vector<std::string>{"bravo"});
  const SelectorAnswer alone = server.CountDeath("bravo");
  ASSERT_TRUE(alone.plan);
  EXPECT_EQ(alone.plan->assignments.size(), 1u);
  EXPECT_EQ(alone.plan->unassigned.at("bravo"),
            "planner for bravo died 2 times (respawned), planned without it");
  // Not in the next cycle either,
  server.CountDeath("bravo");
  server.Take(Rules(2));
  const SelectorAnswer next = server.Take(Offer("alpha", 2, 0, StayAt(-90, 5)));
  ASSERT_TRUE(next.plan);
  EXPECT_EQ(next.plan->unassigned.at("bravo"),
            "planner for bravo died 3 times (respawned), planned without it");
  // until it answers.
  const SelectorAnswer both = server.Take(Offer("bravo", 2, 0, StayAt(-80, 4)));
  ASSERT_TRUE(both.plan);
  EXPECT_EQ(both.plan->assignments.size(), 2u);
  EXPECT_EQ(server.Deaths("bravo"), 0);
}

TEST(TeamSelectorTest, WaitsForAPlannerThatDiedOnceOrAnsweredInBetween) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.CountDeath("bravo");
  ASSERT_TRUE(server.Take(Offer("bravo", 1, 0, StayAt(-80, 4))).plan);
  server.CountDeath("bravo");  // While idle, and back with the same answer.
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  server.Take(Rules(2));
  server.Take(Offer("alpha", 2, 0, StayAt(-90, 5)));
  EXPECT_FALSE(server.CountDeath("bravo").plan);
  EXPECT_TRUE(server.Take(Offer("bravo", 2, 0, StayAt(-80, 4))).plan);
}

// It answers round 0 each time it returns, then dies of the request.
TEST(TeamSelectorTest, DoesNotWaitForAPlannerThatDiesOfARequest) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  ASSERT_TRUE(server.Take(Offer("bravo", 1, 0, StayAt(-90, 4))).request);
  EXPECT_FALSE(server.CountDeath("bravo").plan);
  EXPECT_FALSE(server.Take(Offer("bravo", 1, 0, StayAt(-90, 4))).plan);
  const SelectorAnswer alone = server.CountDeath("bravo");
  ASSERT_TRUE(alone.plan);
  EXPECT_EQ(alone.plan->assignments.size(), 1u);
  EXPECT_EQ(alone.plan->unassigned.count("bravo"), 1u);
}

TEST(TeamSelectorTest, NamesTheInputThatPlannersWorkOn) {
  TeamSelector server;
  EXPECT_EQ(server.LastInput(), "none");
  server.KnowRun(0);
  TeamTask task = Rules(7);
  task.rules.window_end_s = {{2, 1e5}, {5, 4e5}};
  server.Take(task);
  EXPECT_EQ(server.LastInput(),
            "cycle 7, world version 3, round 0, windows 2 to 5");
}

TEST(TeamSelectorTest, ARepeatedAnswerChangesNothing) {
  TeamSelector server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  EXPECT_FALSE(server.Take(Offer("bravo", 1, 0, StayAt(-80, 4))).plan);
}

}  // namespace
}  // namespace kg_engine
