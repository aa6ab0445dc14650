// Rules checked from outside: a checker that shares no code with the selector,
// and random orders of messages.

#include <algorithm>
#include <cmath>

#include "gtest/gtest.h"
#include "kg_selector/team/plan_team.h"
#include "kg_selector/team/team_modes.h"
#include "kg_selector/testing/every_path.h"
#include "kg_selector/testing/random_team.h"
#include "kg_selector/testing/sampled_distance.h"

namespace kg_selector {
namespace {

// --- Checker: uses plan and members only, every two minutes, with geodesics.
// ---

struct MissionRules {
  double separation_m = 0.0;  // Hard minimum distance [m].
  std::map<std::string, int> capacity;
  std::map<std::string, std::set<int>> open;  // Open windows of each event.
  std::map<std::string, const TeamMember*> members;
  double from_s = 0.0;  // Separation is checked from here on [Unix s].
};

int TooCloseOnes(const MissionRules& mission,
                 const std::vector<Pathlet>& plan) {
  int count = 0;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      count += LeastDistance_m(plan[i], plan[k], {mission.from_s, 120.0}) <
               0.9999 * mission.separation_m;
    }
  }
  return count;
}

int BadVisits(const MissionRules& mission, const std::vector<Pathlet>& plan) {
  int count = 0;
  std::map<std::string, std::set<std::string>> users;
  for (const Pathlet& pathlet : plan) {
    for (const Visit& visit : pathlet.visits) {
      for (const std::string& event : visit.events) {
        users[event].insert(pathlet.agent);
        const auto open = mission.open.find(event);
        count +=
            open != mission.open.end() && open->second.count(visit.window) == 0;
      }
    }
  }
  for (const auto& [event, agents] : users) {
    count += static_cast<int>(agents.size()) > mission.capacity.at(event);
  }
  return count;
}

// Visits whose score or energy differs from that of their edges.
int WrongSums(const MissionRules& mission, const std::vector<Pathlet>& plan) {
  int count = 0;
  for (const Pathlet& pathlet : plan) {
    const TeamMember& member = *mission.members.at(pathlet.agent);
    double cost = 0.0;
    double energy_j = 0.0;
    int from = 0;
    for (std::size_t w = 0; w < pathlet.visits.size(); ++w) {
      const int to = pathlet.visits[w].waypoint;
      for (const auto& edge : member.graphs[w].edges) {
        if (edge.from == from && edge.to == to) {
          cost += edge.seam_cost;
          energy_j += edge.flight.energy_j;
        }
      }
      from = to;
    }
    count += energy_j > member.rules.energy_budget_j;
    count += !(std::abs(cost - pathlet.seam_cost) < 1e-9);
    count += !(std::abs(energy_j - pathlet.energy_j) < 1e-6);
    double reward = 0.0;
    for (const Visit& visit : pathlet.visits) reward += visit.reward;
    count += !(std::abs(reward - pathlet.reward) < 1e-9);
  }
  return count;
}

int Violations(const MissionRules& mission, const std::vector<Pathlet>& plan) {
  std::set<std::string> agents;
  for (const Pathlet& pathlet : plan) agents.insert(pathlet.agent);
  return static_cast<int>(plan.size() - agents.size()) +
         TooCloseOnes(mission, plan) + BadVisits(mission, plan) +
         WrongSums(mission, plan);
}

struct TestScene {
  TeamRules rules;
  std::vector<TeamMember> members;
  MissionRules mission;
};

// One in three starts from one place; one in two has an event that expires
// after the first window, and a member that assumes it does not.
TestScene MakeScene(unsigned seed) {
  RandomTeamOptions options;
  options.agents = 2 + static_cast<int>(seed % 4);
  options.places = 10;
  options.same_start = seed % 3 == 0;
  RandomTeam random(options, 5000 + seed);
  TestScene scene;
  scene.rules = random.MakeRules();
  scene.rules.max_rounds = 12;
  scene.members = random.MakeMembers();
  if (seed % 2 == 0) scene.rules.event_windows["ex:event0"] = {0};
  for (const TeamMember& member : scene.members) {
    scene.rules.energy_budget_j[NameOf(member)] = member.rules.energy_budget_j;
  }
  scene.members.back().rules.energy_budget_j = 1e9;
  scene.rules.energy_budget_j[NameOf(scene.members.back())] = 9000.0;
  scene.mission.separation_m = std::max(1.0, scene.rules.separation_m);
  scene.mission.capacity = scene.rules.event_capacity;
  scene.mission.open = scene.rules.event_windows;
  const auto& first = scene.members[0].rules.windows[0];
  scene.mission.from_s = options.same_start ? first.end_s : first.begin_s;
  for (const TeamMember& member : scene.members) {
    scene.mission.members[NameOf(member)] = &member;
  }
  return scene;
}

class RulesOfMode : public testing::TestWithParam<std::string> {};

TEST_P(RulesOfMode, AreKeptInTwoHundredRandomMissions) {
  int would_violate = 0;
  int turned_away = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    TestScene scene = MakeScene(seed);
    scene.rules.mode = GetParam();
    const TeamPlan plan = PlanTeam(scene.rules, scene.members);
    TeamMember honest = scene.members.back();
    honest.rules.energy_budget_j = 9000.0;
    scene.mission.members[NameOf(honest)] = &honest;
    EXPECT_EQ(Violations(scene.mission, plan.committed), 0) << "seed " << seed;
    EXPECT_LE(plan.rounds, scene.rules.max_rounds);
    EXPECT_EQ(plan.committed.size() + plan.unassigned.size(),
              scene.members.size());
    std::vector<Pathlet> selfish;
    for (const TeamMember& member : scene.members) {
      auto found = PlanPriced(scene.rules, member, {});
      if (!found.pathlets.empty()) selfish.push_back(found.pathlets.front());
    }
    would_violate += Violations(scene.mission, selfish) > 0;
    for (const RejectedPath& rejection : plan.rejections) {
      turned_away += rejection.conflict.kind == ConflictKind::kEnergy ||
                     rejection.conflict.kind == ConflictKind::kExpired;
    }
  }
  EXPECT_GT(would_violate, 100);  // The test must not be vacuous.
  EXPECT_GT(turned_away, 50);
}

// --- Order of messages. ---

TeamOutcome InRandomOrder(const TeamRules& rules,
                          const std::vector<TeamMember>& members,
                          std::mt19937* prng) {
  std::vector<std::string> agents;
  std::map<std::string, const TeamMember*> by_agent;
  for (const TeamMember& member : members) {
    agents.push_back(NameOf(member));
    by_agent[NameOf(member)] = &member;
  }
  std::shuffle(agents.begin(), agents.end(), *prng);
  const auto team = MakeCoordinator(rules, agents);
  while (!team->Advance()) {
    std::vector<std::string> order(team->waiting_for().begin(),
                                   team->waiting_for().end());
    std::shuffle(order.begin(), order.end(), *prng);
    for (const std::string& agent : order) {
      AgentOffer answer =
          PlanPriced(rules, *by_agent[agent], team->RequestFor(agent));
      if ((*prng)() % 2 == 0) {  // Duplicate answer with duplicate paths.
        team->Offer(agent, answer);
        const auto once = answer.pathlets;
        answer.pathlets.insert(answer.pathlets.end(), once.begin(), once.end());
      }
      team->Offer(agent, answer);
      team->Offer("ex:stranger", answer);
      if (team->waiting_for().empty()) break;
      EXPECT_FALSE(team->Advance());
    }
  }
  return team->outcome();
}

void ExpectSame(const TeamOutcome& a, const TeamOutcome& b) {
  ASSERT_EQ(a.committed.size(), b.committed.size());
  for (std::size_t k = 0; k < a.committed.size(); ++k) {
    EXPECT_EQ(a.committed[k].agent, b.committed[k].agent);
    EXPECT_EQ(a.committed[k].score(), b.committed[k].score());
    EXPECT_EQ(a.committed[k].rank, b.committed[k].rank);
    EXPECT_EQ(a.committed[k].round, b.committed[k].round);
  }
  EXPECT_EQ(a.rounds, b.rounds);
  EXPECT_EQ(a.bound, b.bound);
  EXPECT_EQ(a.unassigned, b.unassigned);
  ASSERT_EQ(a.rejections.size(), b.rejections.size());
  for (std::size_t k = 0; k < a.rejections.size(); ++k) {
    EXPECT_EQ(a.rejections[k].reason, b.rejections[k].reason);
  }
}

TEST_P(RulesOfMode, TheOrderOfAnswersDoesNotMatter) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomTeamOptions options;
    options.agents = 4;
    RandomTeam random(options, 7000 + seed);
    TeamRules rules = random.MakeRules();
    rules.mode = GetParam();
    rules.max_rounds = 20;
    rules.gap_goal = 0.001;
    rules.time_limit_s = 1e9;
    const auto members = random.MakeMembers();
    for (const auto& window : members[0].rules.windows) {
      rules.window_end_s[window.window] = window.end_s;
    }
    const TeamPlan plan = PlanTeam(rules, members);
    for (int i = 0; i < 4; ++i) {
      ExpectSame(plan, InRandomOrder(rules, members, &random.prng()));
    }
  }
}

TEST_P(RulesOfMode, ADeadAgentIsPlannedWithout) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomTeamOptions options;
    options.agents = 4;
    RandomTeam random(options, 8000 + seed);
    TeamRules rules = random.MakeRules();
    rules.mode = GetParam();
    rules.gap_goal = 0.0;
    const auto members = random.MakeMembers();
    std::vector<std::string> agents;
    for (const TeamMember& member : members) agents.push_back(NameOf(member));
    const auto team = MakeCoordinator(rules, agents);
    for (int round = 0; !team->Advance(); ++round) {
      const std::set<std::string> waiting = team->waiting_for();
      for (const TeamMember& member : members) {
        if (waiting.count(NameOf(member)) > 0) {
          if (NameOf(member) == agents[1] &&
              round >= static_cast<int>(seed % 4)) {
            team->Drop(agents[1], "dead");
          } else {
            team->Offer(
                NameOf(member),
                PlanPriced(rules, member, team->RequestFor(NameOf(member))));
          }
        }
      }
    }
    const TeamOutcome& outcome = team->outcome();
    EXPECT_EQ(outcome.committed.size() + outcome.unassigned.size(), 4u);
    double score = 0.0;
    for (const Pathlet& pathlet : outcome.committed) score += pathlet.score();
    EXPECT_LE(score, outcome.bound + 1e-9);
    const bool dead = outcome.unassigned.count(agents[1]) > 0 &&
                      outcome.unassigned.at(agents[1]) == "dead";
    if (seed % 4 == 0) {
      EXPECT_TRUE(dead);
    }
    if (dead) {
      for (const Pathlet& pathlet : outcome.committed) {
        EXPECT_NE(pathlet.agent, agents[1]);
      }
    }
  }
}

// --- Malformed input. ---

TEST_P(RulesOfMode, NonsenseIsTurnedAwayWithAReason) {
  RandomTeam random({}, 11);
  TeamRules rules;
  rules.mode = GetParam();
  const auto members = random.MakeMembers();
  for (const auto& window : members[0].rules.windows) {
    rules.window_end_s[window.window] = window.end_s;
  }
  const Pathlet sound = PlanPriced(rules, members[0], {}).pathlets.front();
  std::vector<Pathlet> bad(6, sound);
  bad[0].reward = std::nan("");
  bad[1].visits[1].window = 77;
  bad[2].track[1].time_s = 0.0;
  bad[3].track[0].position.lon_deg = std::nan("");
  bad[4].energy_j = HUGE_VAL;
  bad[5].visits[0].window = 2;
  AgentOffer candidates;
  candidates.pathlets = bad;
  candidates.pathlets.push_back(sound);
  const auto team = MakeCoordinator(rules, {"ex:agent0"});
  for (int i = 0; i < 20 && !team->Advance(); ++i) {
    team->Offer("ex:agent0", candidates);
  }
  ASSERT_TRUE(team->Advance());
  ASSERT_EQ(team->outcome().committed.size(), 1u);
  EXPECT_EQ(team->outcome().committed[0].rank, sound.rank);
  ASSERT_GE(team->outcome().rejections.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(team->outcome().rejections[i].reason.rfind("malformed: ", 0), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(AllModes, RulesOfMode,
                         testing::ValuesIn(TeamModeNames()));

}  // namespace
}  // namespace kg_selector
