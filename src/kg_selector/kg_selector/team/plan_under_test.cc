#include <cmath>
#include <limits>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_selector/team/priced_replanning.h"
#include "kg_selector/testing/every_path.h"
#include "kg_selector/testing/random_team.h"

namespace kg_selector {
namespace {

double Price(const PlanRequest& request, int window, int waypoint) {
  double sum = 0.0;
  for (const WaypointPrice& price : request.waypoint_prices) {
    if (price.window == window && price.waypoint == waypoint) {
      sum += price.price;
    }
  }
  return sum;
}

// Value of a path that earns only events that pay.
struct PathWorth {
  double score = 0.0;
  double paid = 0.0;
  std::set<std::string> earned;
};

PathWorth WorthUnder(const PlanRequest& request, const EveryPath& path) {
  PathWorth worth{path.score, 0.0, {}};
  for (std::size_t w = 0; w < path.nodes.size(); ++w) {
    worth.paid += Price(request, static_cast<int>(w), path.nodes[w]);
  }
  for (const auto& [event, reward] : path.events) {
    const auto price = request.event_prices.find(event);
    const double of_event =
        price == request.event_prices.end() ? 0.0 : price->second;
    if (request.full_events.count(event) > 0 || !(reward > of_event)) continue;
    worth.score += reward;
    worth.paid += of_event;
    worth.earned.insert(event);
  }
  return worth;
}

PlanRequest RandomAsk(RandomTeam* random) {
  PlanRequest request;
  for (int i = random->Whole(0, 6); i > 0; --i) {
    request.waypoint_prices.push_back(
        {random->Whole(0, 2), random->Whole(0, 3), random->Number(0.0, 6.0)});
  }
  for (int i = 0; i < 2; ++i) {
    const std::string event = "ex:event" + std::to_string(i);
    if (random->Whole(0, 1) == 1) {
      request.event_prices[event] = random->Number(0.0, 8.0);
    }
    if (random->Whole(0, 5) == 0) request.full_events.insert(event);
  }
  return request;
}

std::set<std::string> EarnedBy(const Pathlet& pathlet) {
  std::set<std::string> earned;
  for (const Visit& visit : pathlet.visits) {
    earned.insert(visit.events.begin(), visit.events.end());
  }
  return earned;
}

TEST(PlanUnderTest, FindsTheBestPathsLessPricesByExhaustion) {
  int dear_events = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    RandomTeam random({}, seed);
    const TeamMember member = random.MakeMembers().front();
    const PlanRequest request = RandomAsk(&random);
    const AgentOffer found = PlanPriced({}, member, request);
    std::vector<double> values;
    std::map<std::vector<int>, PathWorth> by_nodes;
    for (const EveryPath& path : EnumeratePaths(member)) {
      const PathWorth worth = WorthUnder(request, path);
      values.push_back(worth.score - worth.paid);
      by_nodes[path.nodes] = worth;
      dear_events += worth.earned.size() < path.events.size();
    }
    std::sort(values.rbegin(), values.rend());
    ASSERT_EQ(found.pathlets.size(), std::min<std::size_t>(5, values.size()));
    for (std::size_t i = 0; i < found.pathlets.size(); ++i) {
      const Pathlet& pathlet = found.pathlets[i];
      std::vector<int> nodes;
      for (const Visit& visit : pathlet.visits) nodes.push_back(visit.waypoint);
      const PathWorth& worth = by_nodes.at(nodes);
      EXPECT_NEAR(pathlet.score(), worth.score, 1e-9);
      EXPECT_NEAR(worth.score - worth.paid, values[i], 1e-9);
      EXPECT_EQ(EarnedBy(pathlet), worth.earned);
    }
    if (!values.empty()) {
      EXPECT_NEAR(found.bound, values[0], 1e-9);
    }
  }
  EXPECT_GT(dear_events, 1000);
}

TEST(PlanUnderTest, PricesOfNoRowsChangeNothing) {
  RandomTeam random({}, 3);
  const TeamMember member = random.MakeMembers().front();
  PlanRequest free;
  free.waypoint_prices = {{0, 1, 0.0}, {2, 3, 0.0}};
  free.event_prices["ex:event0"] = 0.0;
  const AgentOffer plain = PlanPriced({}, member, {});
  const AgentOffer priced = PlanPriced({}, member, free);
  ASSERT_EQ(plain.pathlets.size(), priced.pathlets.size());
  for (std::size_t i = 0; i < plain.pathlets.size(); ++i) {
    EXPECT_NEAR(plain.pathlets[i].score(), priced.pathlets[i].score(), 1e-9);
    EXPECT_EQ(EarnedBy(plain.pathlets[i]), EarnedBy(priced.pathlets[i]));
  }
}

TEST(PlanUnderTest, RefusesPricesOfNonsense) {
  RandomTeam random({}, 3);
  const TeamMember member = random.MakeMembers().front();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double price : {-1.0, nan, infinity}) {
    PlanRequest request;
    request.waypoint_prices = {{0, 1, price}};
    EXPECT_THROW(PlanPriced({}, member, request), kg_base::InputError);
    request = {};
    request.event_prices["ex:event0"] = price;
    EXPECT_THROW(PlanPriced({}, member, request), kg_base::InputError);
  }
  for (const WaypointPrice& price :
       {WaypointPrice{3, 0, 1.0}, WaypointPrice{0, 4, 1.0},
        WaypointPrice{0, -1, 1.0}}) {
    PlanRequest request;
    request.waypoint_prices = {price};
    EXPECT_THROW(PlanPriced({}, member, request), kg_base::InputError);
  }
}

}  // namespace
}  // namespace kg_selector
