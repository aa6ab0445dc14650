// Every mode against exhaustive search on small teams, and against itself with
// answers in another order.

#include "kg_selector/team/team_modes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_mission/mission/option_names.h"
#include "kg_selector/team/plan_team.h"
#include "kg_selector/testing/every_path.h"
#include "kg_selector/testing/random_team.h"

namespace kg_selector {
namespace {

// --- Reference: the best of all plans. ---

struct PathOption {
  double score = 0.0;
  std::set<std::string> events;
  const EveryPath* path = nullptr;
};

// All paths with all sets of events that they might earn.
std::vector<PathOption> OptionsOf(const std::vector<EveryPath>& paths) {
  std::vector<PathOption> options;
  for (const EveryPath& path : paths) {
    options.push_back({path.score, {}, &path});
    const std::size_t first = options.size() - 1;
    for (const auto& [event, reward] : path.events) {
      for (std::size_t i = first, end = options.size(); i < end; ++i) {
        PathOption earned = options[i];
        earned.score += reward;
        earned.events.insert(event);
        options.push_back(earned);
      }
    }
  }
  std::sort(options.begin(), options.end(),
            [](const PathOption& a, const PathOption& b) {
              return a.score > b.score;
            });
  return options;
}

class BestPlan {
 public:
  // An agent without a path counts `unserved`.
  BestPlan(const TeamRules& rules, const std::vector<TeamMember>& members,
           double unserved)
      : rules_(rules), unserved_(unserved) {
    for (const TeamMember& member : members) {
      paths_.push_back(EnumeratePaths(member));
    }
    for (const auto& paths : paths_) options_.push_back(OptionsOf(paths));
    Extend(0, 0.0);
  }
  double value() const { return best_; }

 private:
  bool Apart(const EveryPath& a, const EveryPath& b) {
    const auto [known, is_new] = apart_.emplace(std::pair(&a, &b), false);
    if (is_new) {
      known->second = ClosestApproach(a.track, b.track)->distance_m >=
                      std::max(1.0, rules_.separation_m);
    }
    return known->second;
  }
  bool Allowed(const PathOption& option) {
    for (const std::string& event : option.events) {
      const auto users = std::count_if(chosen_.begin(), chosen_.end(),
                                       [&](const PathOption* other) {
                                         return other->events.count(event) > 0;
                                       });
      if (users >= rules_.event_capacity.at(event)) return false;
    }
    return std::all_of(chosen_.begin(), chosen_.end(),
                       [&](const PathOption* other) {
                         return Apart(*other->path, *option.path);
                       });
  }
  double MostFrom(std::size_t agent) const {
    double max_value = 0.0;
    for (std::size_t a = agent; a < options_.size(); ++a) {
      max_value += options_[a].empty()
                       ? unserved_
                       : std::max(unserved_, options_[a].front().score);
    }
    return max_value;
  }
  void Extend(std::size_t agent, double sum) {
    if (agent == options_.size()) {
      best_ = std::max(best_, sum);
      return;
    }
    if (sum + MostFrom(agent) <= best_) return;
    for (const PathOption& option : options_[agent]) {
      if (!Allowed(option)) continue;
      chosen_.push_back(&option);
      Extend(agent + 1, sum + option.score);
      chosen_.pop_back();
    }
    Extend(agent + 1, sum + unserved_);
  }

  const TeamRules& rules_;
  double unserved_;
  std::vector<std::vector<EveryPath>> paths_;
  std::vector<std::vector<PathOption>> options_;
  std::map<std::pair<const EveryPath*, const EveryPath*>, bool> apart_;
  std::vector<const PathOption*> chosen_;
  double best_ = -std::numeric_limits<double>::infinity();
};

double WorstPath(const std::vector<TeamMember>& members) {
  double worst = 0.0;
  for (const TeamMember& member : members) {
    for (const EveryPath& path : EnumeratePaths(member)) {
      double score = path.score;
      for (const auto& [event, reward] : path.events) score += reward;
      worst = std::min(worst, score);
    }
  }
  return worst;
}

// Teams of 2 to 4 agents in two windows with 0 or 2 events.
RandomTeamOptions SmallTeam(unsigned seed) {
  RandomTeamOptions options;
  options.agents = 2 + static_cast<int>(seed % 3);
  options.windows = 2;
  options.waypoints = 3;
  options.events = static_cast<int>(seed % 2) * 2;
  return options;
}

class OfMode : public testing::TestWithParam<std::string> {};

TEST_P(OfMode, StaysBetweenWhatIsPossibleAndItsBound) {
  int below = 0;
  double share = 0.0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    RandomTeam random(SmallTeam(seed), 20000 + seed);
    TeamRules rules = random.MakeRules();
    rules.mode = GetParam();
    rules.gap_goal = 0.0;
    rules.max_rounds = 30;
    const auto members = random.MakeMembers();
    const TeamPlan plan = PlanTeam(rules, members);
    const double optimum = BestPlan(rules, members, 0.0).value();
    ASSERT_LE(plan.score(), optimum + 1e-9) << seed;
    ASSERT_GE(plan.bound, optimum - 1e-9) << seed;
    ASSERT_LE(plan.rounds, rules.max_rounds);
    ASSERT_EQ(plan.committed.size() + plan.unassigned.size(), members.size());
    below += plan.score() < optimum - 1e-9;
    share += (optimum > 0.0 ? plan.score() / optimum : 1.0) / 1000.0;
  }
  std::printf("%s: %.3f %% of the optimum, below it in %d of 1000\n",
              GetParam().c_str(), 100.0 * share, below);
  EXPECT_GT(share, GetParam() == "greedy" ? 0.92 : 0.985);
}

TEST(TeamModes, ImplementEveryNameOfExTeamMode) {
  EXPECT_EQ(TeamModeNames(),
            std::vector<std::string>(std::begin(kg_mission::kTeamModeNames),
                                     std::end(kg_mission::kTeamModeNames)));
}

TEST(TeamModes, AreNamedInErrors) {
  EXPECT_EQ("greedy, auction, priced or exact", TeamModeChoices());
  EXPECT_EQ("'greedy', 'auction', 'priced' or 'exact'", TeamModeChoices("'"));
  EXPECT_EQ(nullptr, FindTeamMode("lottery"));
}

INSTANTIATE_TEST_SUITE_P(AllModes, OfMode, testing::ValuesIn(TeamModeNames()));

TEST(ExactTest, IsTheBestOfAllPlansIfAllPathsAreOffered) {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    RandomTeamOptions options = SmallTeam(seed);
    options.events = 0;
    RandomTeam random(options, 30000 + seed);
    TeamRules rules = random.MakeRules();
    rules.mode = "exact";
    rules.time_limit_s = 1e9;
    auto members = random.MakeMembers();
    for (TeamMember& member : members) member.rules.candidates = 1000;
    const TeamPlan plan = PlanTeam(rules, members);
    const double unserved = WorstPath(members);
    const double value =
        plan.score() +
        unserved * static_cast<double>(members.size() - plan.committed.size());
    ASSERT_NEAR(value, BestPlan(rules, members, unserved).value(), 1e-6)
        << seed;
  }
}

}  // namespace
}  // namespace kg_selector
