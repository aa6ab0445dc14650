#include "kg_selector/team/plan_team.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "gtest/gtest.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/team/greedy_team.h"
#include "kg_selector/testing/random_team.h"
#include "kg_selector/testing/sampled_distance.h"

namespace kg_selector {
namespace {

using kg_compiler::TimedPoint;

// --- Reference: greedy over all paths of all agents: best first, filter,
// repeat. ---

struct PathOption {
  std::vector<int> nodes;
  double score = 0.0;
  std::set<std::string> events;
  std::vector<TimedPoint> track;
};

class ReferencePlan {
 public:
  ReferencePlan(const TeamRules& rules, const std::vector<TeamMember>& members)
      : rules_(rules) {
    for (const TeamMember& member : members) {
      left_[member.rules.agent_iri] = &member;
    }
    while (CommitOne()) {
    }
  }

  struct Choice {
    std::string agent;
    PathOption option;
  };
  const std::vector<Choice>& choices() const { return choices_; }

 private:
  bool Full(const std::string& event) const {
    const auto agents = std::count_if(
        choices_.begin(), choices_.end(), [&](const Choice& choice) {
          return choice.option.events.count(event);
        });
    return agents >= rules_.event_capacity.at(event);
  }

  bool Allowed(const PathOption& option) const {
    const double least_m = std::max(1.0, rules_.separation_m);
    return std::none_of(
        choices_.begin(), choices_.end(), [&](const Choice& choice) {
          return ClosestApproach(option.track, choice.option.track)
                     ->distance_m < least_m;
        });
  }

  // Depth first over all paths of a member; `best` is the best allowed.
  void Extend(const TeamMember& member, const PathOption& option,
              double energy_j, std::map<std::string, double> events,
              std::optional<PathOption>* best) const {
    const std::size_t stage = option.nodes.size();
    if (stage == member.graphs.size()) {
      PathOption whole = option;
      for (const auto& [event, reward] : events) {
        whole.score += reward;
        whole.events.insert(event);
      }
      if (energy_j <= member.rules.energy_budget_j &&
          (!*best || whole.score > (*best)->score) && Allowed(whole)) {
        *best = whole;
      }
      return;
    }
    for (const auto& edge : member.graphs[stage].edges) {
      if (edge.from != (stage == 0 ? 0 : option.nodes.back())) continue;
      const auto& waypoint = member.graphs[stage].waypoints[edge.to];
      PathOption longer = option;
      longer.nodes.push_back(edge.to);
      longer.score += waypoint.score - edge.seam_cost;
      longer.track.insert(longer.track.end(), edge.flight.track.begin(),
                          edge.flight.track.end());
      auto earned = events;
      for (const auto& rule : member.rules.windows[stage].events) {
        if (!waypoint.events.empty() && waypoint.events[0] == rule.iri &&
            !Full(rule.iri)) {
          earned[rule.iri] = std::max(earned[rule.iri], rule.reward);
        }
      }
      Extend(member, longer, energy_j + edge.flight.energy_j, earned, best);
    }
  }

  bool CommitOne() {
    std::optional<Choice> best;
    for (const auto& [agent, member] : left_) {
      std::optional<PathOption> own;
      Extend(*member, {}, 0.0, {}, &own);
      if (own && (!best || own->score > best->option.score)) {
        best = Choice{agent, *own};
      }
    }
    if (!best) return false;
    left_.erase(best->agent);
    choices_.push_back(*best);
    return true;
  }

  const TeamRules& rules_;
  std::map<std::string, const TeamMember*> left_;
  std::vector<Choice> choices_;
};

TEST(PlanTeamTest, EqualsBestFirstMaskAndPlanAgainByExhaustion) {
  int replanned = 0;
  int alone = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    RandomTeam random({}, seed);
    const TeamRules rules = random.MakeRules();
    const auto members = random.MakeMembers();
    const TeamPlan plan = PlanTeam(rules, members);
    const ReferencePlan reference(rules, members);
    ASSERT_EQ(plan.committed.size(), reference.choices().size());
    for (std::size_t i = 0; i < plan.committed.size(); ++i) {
      const Pathlet& pathlet = plan.committed[i];
      const auto& choice = reference.choices()[i];
      ASSERT_EQ(pathlet.agent, choice.agent);
      ASSERT_NEAR(pathlet.score(), choice.option.score, 1e-9);
      for (std::size_t w = 0; w < pathlet.visits.size(); ++w) {
        ASSERT_EQ(pathlet.visits[w].waypoint, choice.option.nodes[w]);
      }
    }
    EXPECT_EQ(plan.committed.size() + plan.unassigned.size(), members.size());
    EXPECT_TRUE(plan.proven);
    replanned += plan.rounds > 1;
    alone += !plan.unassigned.empty();
  }
  EXPECT_GT(replanned, 50);
  EXPECT_GT(alone, 5);
}

// --- Checker: uses the plan only, sampled every minute. ---

// Number of violations. Agents from one ship are checked from the end of the
// first window on.
int Violations(const TeamRules& rules, const std::vector<Pathlet>& plan,
               double from_s) {
  int violations = 0;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      violations += LeastDistance_m(plan[i], plan[k], {from_s, 60.0}) <
                    0.9999 * std::max(1.0, rules.separation_m);
    }
  }
  for (const auto& [event, capacity] : rules.event_capacity) {
    std::set<std::string> agents;
    for (const Pathlet& pathlet : plan) {
      for (const Visit& visit : pathlet.visits) {
        if (std::count(visit.events.begin(), visit.events.end(), event) > 0) {
          agents.insert(pathlet.agent);
        }
      }
    }
    violations += static_cast<int>(agents.size()) > capacity;
  }
  return violations;
}

TEST(PlanTeamTest, TwoHundredRandomTeamsKeepTheRules) {
  int would_violate = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    RandomTeamOptions options;
    options.agents = 2 + static_cast<int>(seed % 5);
    options.places = 10;
    options.same_start = seed % 3 == 0;
    RandomTeam random(options, 5000 + seed);
    const TeamRules rules = random.MakeRules();
    const auto members = random.MakeMembers();
    const TeamPlan plan = PlanTeam(rules, members);
    const auto& first = members[0].rules.windows[0];
    const double from_s = options.same_start ? first.end_s : first.begin_s;
    EXPECT_EQ(Violations(rules, plan.committed, from_s), 0) << "seed " << seed;
    EXPECT_LE(plan.rounds, options.agents);
    EXPECT_EQ(plan.committed.size() + plan.unassigned.size(), members.size());
    std::vector<Pathlet> selfish;
    for (const TeamMember& member : members) {
      auto found = PlanPriced(rules, member, {});
      if (!found.pathlets.empty()) selfish.push_back(found.pathlets.front());
    }
    would_violate += Violations(rules, selfish, from_s) > 0;
  }
  EXPECT_GT(would_violate, 100);  // The test must not be vacuous.
}

// --- Order of messages. ---

TeamPlan PlanInRandomOrder(const TeamRules& rules,
                           const std::vector<TeamMember>& members,
                           std::mt19937* prng) {
  std::vector<std::string> agents;
  std::map<std::string, const TeamMember*> by_agent;
  for (const TeamMember& member : members) {
    agents.push_back(member.rules.agent_iri);
    by_agent[member.rules.agent_iri] = &member;
  }
  std::shuffle(agents.begin(), agents.end(), *prng);
  GreedyTeam team(rules, agents);
  while (!team.Advance()) {
    std::vector<std::string> order(team.waiting_for().begin(),
                                   team.waiting_for().end());
    std::shuffle(order.begin(), order.end(), *prng);
    for (const std::string& agent : order) {
      team.Offer(agent,
                 PlanPriced(rules, *by_agent[agent], team.RequestFor(agent)));
      if (team.waiting_for().empty()) break;
      EXPECT_FALSE(team.Advance());
    }
  }
  TeamPlan plan;
  static_cast<TeamOutcome&>(plan) = team.outcome();
  return plan;
}

TEST(PlanTeamTest, TheOrderOfAnswersDoesNotMatter) {
  RandomTeamOptions options;
  options.agents = 4;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    RandomTeam random(options, 7000 + seed);
    TeamRules rules = random.MakeRules();
    const auto members = random.MakeMembers();
    for (const auto& window : members[0].rules.windows) {
      rules.window_end_s[window.window] = window.end_s;
    }
    const TeamPlan plan = PlanTeam(rules, members);
    for (int i = 0; i < 10; ++i) {
      const TeamPlan other = PlanInRandomOrder(rules, members, &random.prng());
      ASSERT_EQ(plan.committed.size(), other.committed.size());
      for (std::size_t k = 0; k < plan.committed.size(); ++k) {
        EXPECT_EQ(plan.committed[k].agent, other.committed[k].agent);
        EXPECT_EQ(plan.committed[k].score(), other.committed[k].score());
      }
      EXPECT_EQ(plan.rounds, other.rounds);
      EXPECT_EQ(plan.unassigned, other.unassigned);
      ASSERT_EQ(plan.rejections.size(), other.rejections.size());
      for (std::size_t k = 0; k < plan.rejections.size(); ++k) {
        EXPECT_EQ(plan.rejections[k].reason, other.rejections[k].reason);
      }
    }
  }
}

TEST(PlanTeamTest, TwoIdenticalAgentsNeverShareAWaypoint) {
  int both = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    RandomTeamOptions options;
    options.agents = 1;
    RandomTeam random(options, 9000 + seed);
    TeamRules rules = random.MakeRules();
    rules.separation_m = 0.0;
    auto members = random.MakeMembers();
    members.push_back(members.front());
    members.back().rules.agent_iri = "ex:twin";
    const TeamPlan plan = PlanTeam(rules, members);
    if (plan.committed.size() < 2) continue;
    ++both;
    for (std::size_t w = 0; w < plan.committed[0].visits.size(); ++w) {
      EXPECT_NE(plan.committed[0].visits[w].waypoint,
                plan.committed[1].visits[w].waypoint);
    }
  }
  EXPECT_GT(both, 60);
}

TEST(PlanTeamTest, AnEmptyTeamHasAnEmptyPlan) {
  const TeamPlan plan = PlanTeam({}, {});
  EXPECT_TRUE(plan.committed.empty());
  EXPECT_EQ(plan.score(), 0.0);
}

}  // namespace
}  // namespace kg_selector
