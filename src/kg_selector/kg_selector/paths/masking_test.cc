#include "kg_selector/paths/masking.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>

#include "gtest/gtest.h"
#include "kg_selector/team/plan_team.h"
#include "kg_selector/testing/random_team.h"

namespace kg_selector {
namespace {

using kg_planner::FindKBest;
using kg_planner::Path;

// Every path of an agent.
std::vector<Path> AllPaths(const kg_planner::Trellis& trellis) {
  return FindKBest(trellis, {}, {100000, 1000000}).paths;
}

bool Uses(const kg_planner::Trellis& trellis, const Path& path,
          const kg_planner::SeamMask& seam) {
  const kg_planner::Stage& stage = trellis.stages[seam.stage];
  const int taken = path.seams[seam.stage];
  return stage.seams[taken].from == seam.from &&
         stage.seams[taken].to == seam.to &&
         (stage.via.empty() ? seam.via.empty() : stage.via[taken] == seam.via);
}

std::vector<Pathlet> Others(const TeamRules& rules,
                            const std::vector<TeamMember>& members) {
  std::vector<Pathlet> committed;
  for (std::size_t i = 1; i < members.size(); ++i) {
    const AgentOffer found =
        PlanPriced(rules, members[i], RequestAround(rules, committed));
    if (!found.pathlets.empty()) committed.push_back(found.pathlets.front());
  }
  return committed;
}

struct MaskCounts {
  int masked = 0;
  int open = 0;
  int planned = 0;
};

// The masked paths are exactly those separation rules out, the closed events
// exactly those at capacity.
void CheckMasks(const TeamRules& rules, const std::vector<TeamMember>& members,
                MaskCounts* counts) {
  const std::vector<Pathlet> committed = Others(rules, members);
  const TeamMember& member = members.front();
  const auto masks = MaskCommitted(rules, member.graphs, committed);
  EXPECT_TRUE(masks.nodes.empty());
  const auto open = CloseEvents(member.rules, FullEvents(rules, committed));
  const auto trellis = ToTrellis(open, member.graphs);
  for (const Path& path : AllPaths(trellis)) {
    const bool masked = std::any_of(masks.seams.begin(), masks.seams.end(),
                                    [&](const kg_planner::SeamMask& seam) {
                                      return Uses(trellis, path, seam);
                                    });
    const Pathlet pathlet = ToPathlet(open, member.graphs, path, 0);
    ASSERT_EQ(masked, FindConflict(rules, committed, pathlet).has_value());
    ++(masked ? counts->masked : counts->open);
  }
  for (const Pathlet& pathlet :
       PlanPriced(rules, member, RequestAround(rules, committed)).pathlets) {
    ASSERT_FALSE(FindConflict(rules, committed, pathlet));
    ++counts->planned;
  }
}

MaskCounts CheckRandomMasks(const RandomTeamOptions& options, unsigned seed) {
  MaskCounts counts;
  for (unsigned i = 0; i < 150; ++i) {
    RandomTeam random(options, seed + i);
    TeamRules rules = random.MakeRules();
    const auto members = random.MakeMembers();
    if (i % 2 == 0) {
      for (const auto& window : members[0].rules.windows) {
        rules.window_end_s[window.window] = window.end_s;
      }
    }
    CheckMasks(rules, members, &counts);
    if (testing::Test::HasFatalFailure()) break;
  }
  return counts;
}

TEST(MaskCommittedTest, MasksExactlyWhatWouldConflict) {
  const MaskCounts counts = CheckRandomMasks({}, 1000);
  EXPECT_GT(counts.masked, 500);
  EXPECT_GT(counts.open, 500);
  EXPECT_GT(counts.planned, 300);
}

TEST(MaskCommittedTest, MasksExactlyWhatWouldConflictFromOneShip) {
  RandomTeamOptions options;
  options.same_start = true;
  const MaskCounts counts = CheckRandomMasks(options, 2000);
  EXPECT_GT(counts.masked, 500);
  EXPECT_GT(counts.open, 500);
  EXPECT_GT(counts.planned, 100);
}

TEST(MaskCommittedTest, MasksExactlyTheWalksThatWouldConflict) {
  RandomTeamOptions options;
  options.walks = true;
  options.waypoints = 3;
  const MaskCounts counts = CheckRandomMasks(options, 4000);
  EXPECT_GT(counts.masked, 500);
  EXPECT_GT(counts.open, 500);
  EXPECT_GT(counts.planned, 300);
}

TEST(ToPathletTest, StopsAndTheirEventsCountInTheirWindow) {
  RandomTeamOptions options;
  options.walks = true;
  options.events = 3;
  int by_stops = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    RandomTeam random(options, seed);
    const TeamMember member = random.MakeMembers().front();
    for (const Path& path : AllPaths(ToTrellis(member.rules, member.graphs))) {
      const Pathlet pathlet = ToPathlet(member.rules, member.graphs, path, 0);
      for (std::size_t s = 0; s < pathlet.visits.size(); ++s) {
        const Visit& visit = pathlet.visits[s];
        const auto& edge = member.graphs[s].edges[path.seams[s]];
        ASSERT_EQ(StopsOf(visit), StopsOf(edge));
        double reward = 0.0;
        std::set<std::string> there;
        for (const int stop : StopsOf(visit)) {
          const auto& waypoint = member.graphs[s].waypoints[stop];
          reward += waypoint.score;
          there.insert(waypoint.events.begin(), waypoint.events.end());
        }
        for (const std::string& event : visit.events) {
          ASSERT_EQ(there.count(event), 1u);
          for (const auto& rule : member.rules.windows[s].events) {
            if (rule.iri == event) reward += rule.reward;
          }
          const auto& end = member.graphs[s].waypoints[visit.waypoint].events;
          by_stops += std::count(end.begin(), end.end(), event) == 0;
        }
        EXPECT_NEAR(reward, visit.reward, 1e-9);
        for (const Stop& stop : visit.via) {
          EXPECT_EQ(stop.position,
                    member.graphs[s].waypoints[stop.waypoint].position);
        }
      }
    }
  }
  EXPECT_GT(by_stops, 50);
}

TEST(MaskCommittedTest, WaitingBetweenWindowsCountsToo) {
  RandomTeamOptions options;
  options.gap_s = 3600.0;
  const MaskCounts counts = CheckRandomMasks(options, 3000);
  EXPECT_GT(counts.masked, 500);
  EXPECT_GT(counts.open, 500);
}

TEST(ToPathletTest, VisitsAddUpToThePath) {
  RandomTeamOptions options;
  options.events = 3;
  int earned = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    RandomTeam random(options, seed);
    const TeamMember member = random.MakeMembers().front();
    for (const Path& path : AllPaths(ToTrellis(member.rules, member.graphs))) {
      const Pathlet pathlet = ToPathlet(member.rules, member.graphs, path, 4);
      EXPECT_EQ(pathlet.rank, 4);
      double reward = 0.0;
      std::multiset<std::string> events;
      for (const Visit& visit : pathlet.visits) {
        reward += visit.reward;
        events.insert(visit.events.begin(), visit.events.end());
      }
      EXPECT_NEAR(reward, pathlet.reward, 1e-9);
      EXPECT_NEAR(pathlet.score(), path.score(), 1e-12);
      EXPECT_EQ(events.size(),
                std::set<std::string>(events.begin(), events.end()).size());
      earned += static_cast<int>(events.size());
      ASSERT_TRUE(std::is_sorted(
          pathlet.track.begin(), pathlet.track.end(),
          [](const auto& a, const auto& b) { return a.time_s < b.time_s; }));
    }
  }
  EXPECT_GT(earned, 100);
}

// One window, two waypoints at two events.
TeamMember Small() {
  TeamMember member;
  member.rules.agent_iri = "ex:a";
  member.rules.energy_budget_j = 50.0;
  member.rules.windows.resize(2);
  for (int w = 0; w < 2; ++w) {
    auto& window = member.rules.windows[w];
    window.window = w + 4;
    window.begin_s = 100.0 * w;
    window.end_s = 100.0 * w + 100.0;
    window.events = {{"ex:e", {0.0, 0.0}, 5.0 + w, 10.0}};
    kg_compiler::NavGraph graph;
    graph.window = w + 4;
    graph.waypoints = {{0, {0.0, 0.0}, 2.0, 0.5, {"ex:e", "ex:gone"}, 0.0}};
    graph.edges.resize(1);
    graph.edges[0].seam_cost = 0.5;
    graph.edges[0].flight.energy_j = 20.0;
    graph.edges[0].flight.track = {{{0.0, 0.0}, 100.0 * w},
                                   {{0.0, 0.0}, 100.0 * w + 100.0}};
    member.graphs.push_back(graph);
  }
  return member;
}

TEST(ToTrellisTest, HasStagesNodesTokensAndTheBudget) {
  const TeamMember member = Small();
  const auto trellis = ToTrellis(member.rules, member.graphs);
  EXPECT_EQ(trellis.resource_limit, 50.0);
  ASSERT_EQ(trellis.stages.size(), 2u);
  const kg_planner::Node& node = trellis.stages[1].nodes.at(0);
  EXPECT_EQ(node.reward, 2.0);
  ASSERT_EQ(node.tokens.size(), 1u);  // ex:gone has no reward.
  EXPECT_EQ(node.tokens[0].reward, 6.0);
  EXPECT_EQ(node.tokens[0].token, trellis.stages[0].nodes[0].tokens[0].token);
  EXPECT_EQ(trellis.stages[1].seams.at(0).cost, 0.5);
  EXPECT_EQ(trellis.stages[1].seams.at(0).resource, 20.0);
}

TEST(ToTrellisTest, ClosedEventsLeaveTheirPlaceOpen) {
  const TeamMember member = Small();
  const auto closed = CloseEvents(member.rules, {"ex:e"});
  const auto trellis = ToTrellis(closed, member.graphs);
  EXPECT_EQ(trellis.stages[0].nodes.at(0).reward, 2.0);
  EXPECT_TRUE(trellis.stages[0].nodes.at(0).tokens.empty());
}

TEST(ToPathletTest, ListsAnEventWhereItPaysMost) {
  const TeamMember member = Small();
  const auto best =
      FindKBest(ToTrellis(member.rules, member.graphs), {}, {1, 10});
  const Pathlet pathlet =
      ToPathlet(member.rules, member.graphs, best.paths.at(0), 0);
  EXPECT_EQ(pathlet.agent, "ex:a");
  EXPECT_DOUBLE_EQ(pathlet.score(), 2.0 + 2.0 + 6.0 - 1.0);
  EXPECT_TRUE(pathlet.visits.at(0).events.empty());
  EXPECT_EQ(pathlet.visits.at(1).events, std::vector<std::string>{"ex:e"});
  EXPECT_EQ(pathlet.visits.at(1).reward, 8.0);
  EXPECT_EQ(pathlet.visits.at(1).window, 5);
}

TEST(ToPathletTest, RefusesAPathThatTheGraphsDoNotHave) {
  TeamMember member = Small();
  kg_compiler::NavGraph bare = member.graphs[1];
  bare.edges.clear();
  member.graphs.Replace(1, bare);
  EXPECT_THROW(
      ToPathlet(member.rules, member.graphs, {{0, 0}, 0.0, 0.0, 0.0}, 0),
      std::logic_error);
}

}  // namespace
}  // namespace kg_selector
