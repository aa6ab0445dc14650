// Requests reach exactly the named agents, with exactly the stated conditions.

#include "kg_selector/team/round_request.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"

namespace kg_selector {
namespace {

TEST(RoundRequest, AnAskComesBackAsItWas) {
  Pathlet committed;
  committed.agent = "alpha";
  committed.track = {{{-90.0, 25.0}, 1.8e9}, {{-89.0, 24.0}, 1.8e9 + 9.0}};
  PlanRequest ask;
  ask.around = {committed};
  ask.full_events = {"ex:e", "ex:f"};
  ask.waypoint_prices = {{2, 7, 0.1}, {3, 0, 1e-3}};
  ask.event_prices = {{"ex:g", 2.5}};
  TeamRules rules;
  rules.separation_m = 3000.0;
  RoundRequest request;
  request.time_s = 1.7e9;
  AddAsk("bravo", ask, rules, &request);
  AddAsk("charlie", {}, rules, &request);
  const auto back = AskOf(request, "bravo");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->separation_m, 3000.0);
  ASSERT_EQ(back->ask.around.size(), 1u);
  EXPECT_EQ(back->ask.around[0].agent, "alpha");
  EXPECT_EQ(back->ask.around[0].track.size(), 2u);
  EXPECT_EQ(back->ask.full_events, ask.full_events);
  ASSERT_EQ(back->ask.waypoint_prices.size(), 2u);
  EXPECT_EQ(back->ask.waypoint_prices[1].window, 3);
  EXPECT_EQ(back->ask.waypoint_prices[0].waypoint, 7);
  EXPECT_EQ(back->ask.waypoint_prices[0].price, 0.1);
  EXPECT_EQ(back->ask.event_prices, ask.event_prices);
  EXPECT_EQ(request.cooling.at(0).expires_s, 1.7e9);
  const auto free = AskOf(request, "charlie");
  ASSERT_TRUE(free);  // Asked again without conditions.
  EXPECT_TRUE(free->ask.around.empty());
  EXPECT_TRUE(free->ask.waypoint_prices.empty());
  EXPECT_FALSE(AskOf(request, "alpha"));
}

TEST(RoundRequest, AnEventMayBeFullWithoutATrackInTheWay) {
  PlanRequest ask;
  ask.full_events = {"ex:e"};
  RoundRequest request;
  AddAsk("bravo", ask, {}, &request);
  const auto back = AskOf(request, "bravo");
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->ask.around.empty());
  EXPECT_EQ(back->ask.full_events, ask.full_events);
}

TEST(RoundRequest, APriceWithoutAnAgentAppliesToAllAgentsAsked) {
  RoundRequest request;
  request.asked = {"alpha", "bravo"};
  request.prices.resize(2);
  request.prices[0].event = "ex:e";
  request.prices[0].price = 2.0;
  request.prices[1].agent = "bravo";
  request.prices[1].price = 1.0;
  EXPECT_EQ(AskOf(request, "alpha")->ask.event_prices.at("ex:e"), 2.0);
  EXPECT_TRUE(AskOf(request, "alpha")->ask.waypoint_prices.empty());
  EXPECT_EQ(AskOf(request, "bravo")->ask.waypoint_prices.size(), 1u);
  for (const double bad : {-1.0, static_cast<double>(NAN)}) {
    request.prices[1].price = bad;
    EXPECT_THROW(AskOf(request, "bravo"), kg_base::InputError);
    EXPECT_NO_THROW(AskOf(request, "alpha"));
  }
}

// Requests and ends come on two topics: they may overtake each other.
TEST(RoundRequest, AnEndClosesTheRequestsOfItsRunAndOfEarlierOnes) {
  RoundRequest request;
  request.time_s = 100.0;
  request.cycle = 6;
  request.run = 7;
  RunEnd end;
  end.time_s = 101.0;
  end.cycle = 6;
  end.run = 7;
  EXPECT_TRUE(HasEnded(request, end));
  end.run = 8;  // A run without requests of its own.
  EXPECT_TRUE(HasEnded(request, end));
  end.run = 6;  // Late: the next run is under way already.
  EXPECT_FALSE(HasEnded(request, end));
  end.run = 7;
  end.cycle = 5;
  EXPECT_FALSE(HasEnded(request, end));
  end.cycle = 6;
  end.time_s = 99.0;  // From an earlier selector that used the same run number.
  EXPECT_FALSE(HasEnded(request, end));
}

}  // namespace
}  // namespace kg_selector
