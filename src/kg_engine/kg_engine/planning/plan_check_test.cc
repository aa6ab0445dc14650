// The selector's rules and the independent check of plans
// (src/mission/scripts/plan_check.py) on the same random plans: both accept a
// plan, or both reject it.

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "kg_base/common/temporary_folder.h"
#include "kg_selector/paths/conflict.h"

namespace kg_engine {
namespace {

using Json = nlohmann::json;
using kg_selector::Conflict;
using kg_selector::Pathlet;
using kg_selector::TeamRules;

constexpr int kWindows = 3;
constexpr double kWindow_s = 21600.0;
constexpr double kDegreesPerKm = 0.009;
// The two measure distances differently; plans this close to the limit are
// not compared.
constexpr double kDoubtful_m = 5.0;

struct RandomPlan {
  TeamRules rules;
  std::vector<Pathlet> paths;  // In the order of commitment.
};

class PlanMaker {
 public:
  explicit PlanMaker(unsigned seed) : random_(seed) {}

  RandomPlan Make() {
    RandomPlan plan;
    plan.rules.separation_m = Uniform(500.0, 3000.0);
    plan.rules.separation_is_hard = Uniform(0.0, 1.0) < 0.9;
    for (int w = 0; w < kWindows; ++w) {
      plan.rules.window_end_s[w] = (w + 1) * kWindow_s;
    }
    for (const char* event : {"ex:e", "ex:f"}) {
      plan.rules.event_capacity[event] = Integer(1, 2);
      plan.rules.event_windows[event] = {Integer(0, 1), Integer(1, 2)};
    }
    const int agents = Integer(2, 3);
    for (int i = 0; i < agents; ++i) plan.paths.push_back(MakePath(i));
    return plan;
  }

 private:
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int Integer(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random_);
  }
  kg_base::LonLat Near(const kg_base::LonLat& place, double km) {
    const double reach_deg = km * kDegreesPerKm;
    return {place.lon_deg + Uniform(-reach_deg, reach_deg),
            place.lat_deg + Uniform(-reach_deg, reach_deg)};
  }

  // From the ship to a place of its own and around that, or from there.
  Pathlet MakePath(int index) {
    const kg_base::LonLat ship = {-90.0, 25.0};
    const kg_base::LonLat home = {
        -90.0 + kDegreesPerKm * Uniform(2.0, 6.0) * index, 25.0};
    Pathlet path;
    path.agent = std::string(1, static_cast<char>('a' + index));
    const bool is_launched = Uniform(0.0, 1.0) < 0.7;
    path.track.push_back({is_launched ? Near(ship, 0.8) : Near(home, 0.8),
                          Integer(0, 3) == 0 ? Uniform(0.0, 9000.0) : 0.0});
    const double home_s = Uniform(10000.0, 1.3 * kWindow_s);
    path.track.push_back({home, home_s});
    for (int w = 0; w < kWindows; ++w) {
      const double end_s = (w + 1) * kWindow_s;
      if (end_s > home_s) path.track.push_back({Near(home, 1.0), end_s});
      path.visits.push_back({w, 0, home, 0.0, {}});
      for (const char* event : {"ex:e", "ex:f"}) {
        if (Integer(0, 5) == 0) path.visits.back().events.push_back(event);
      }
    }
    return path;
  }

  std::mt19937 random_;
};

// Do paths exclude one another by separation alone, at this distance?
bool IsTooClose(RandomPlan plan, double extra_m) {
  plan.rules.event_capacity.clear();
  plan.rules.separation_m += extra_m;
  for (std::size_t i = 1; i < plan.paths.size(); ++i) {
    const std::vector<Pathlet> before(
        plan.paths.begin(),
        plan.paths.begin() + static_cast<std::ptrdiff_t>(i));
    if (FindConflict(plan.rules, before, plan.paths[i])) return true;
  }
  return false;
}

// Do paths break the rules of events?
bool IsOverCapacity(RandomPlan plan) {
  for (Pathlet& path : plan.paths) path.track.clear();
  for (std::size_t i = 0; i < plan.paths.size(); ++i) {
    const std::vector<Pathlet> before(
        plan.paths.begin(),
        plan.paths.begin() + static_cast<std::ptrdiff_t>(i));
    if (FindViolation(plan.rules, plan.paths[i]) ||
        FindConflict(plan.rules, before, plan.paths[i])) {
      return true;
    }
  }
  return false;
}

Json PathToJson(const Pathlet& path) {
  Json json;
  for (const auto& point : path.track) {
    json["track"].push_back(
        {point.time_s, point.position.lon_deg, point.position.lat_deg});
  }
  for (const kg_selector::Visit& visit : path.visits) {
    json["visits"].push_back({visit.window, visit.position.lon_deg,
                              visit.position.lat_deg, Json(visit.events)});
  }
  return json;
}

// For judge_plans.py. All visits are written at the events' place, so that only
// windows and capacity matter.
Json ToJson(const RandomPlan& plan) {
  Json json;
  for (int w = 0; w < kWindows; ++w) {
    json["windows"].push_back({w * kWindow_s, (w + 1) * kWindow_s});
  }
  json["separation"] = {{"m", plan.rules.separation_m},
                        {"is_hard", plan.rules.separation_is_hard}};
  for (const auto& [event, capacity] : plan.rules.event_capacity) {
    json["events"][event] = {{"lon", -90.0},
                             {"lat", 25.0},
                             {"capacity", capacity},
                             {"windows", plan.rules.event_windows.at(event)}};
  }
  for (Pathlet path : plan.paths) {
    for (kg_selector::Visit& visit : path.visits) {
      visit.position = {-90.0, 25.0};
    }
    json["agents"][path.agent] = PathToJson(path);
  }
  return json;
}

struct CheckFindings {
  int separation = 0;
  int capacity = 0;
};

std::vector<CheckFindings> RunCheck(const std::vector<RandomPlan>& plans) {
  const kg_base::TemporaryFolder folder;
  const std::string path = folder / "plans.jsonl";
  {
    std::ofstream file(path);
    for (const RandomPlan& plan : plans) file << ToJson(plan).dump() << "\n";
  }
  const std::string command =
      "/usr/bin/python3 -B ../mission/test/judge_plans.py " + path;
  std::vector<CheckFindings> all;
  FILE* output = popen(command.c_str(), "r");
  CheckFindings found;
  while (std::fscanf(output, "%d %d", &found.separation, &found.capacity) ==
         2) {
    all.push_back(found);
  }
  EXPECT_EQ(pclose(output), 0);
  return all;
}

TEST(PlanCheckTest, AgreesWithTheSelectorOnRandomPlans) {
  PlanMaker maker(20260602);
  std::vector<RandomPlan> plans;
  for (int i = 0; i < 400; ++i) plans.push_back(maker.Make());
  const std::vector<CheckFindings> findings = RunCheck(plans);
  ASSERT_EQ(findings.size(), plans.size());
  int compared = 0, close = 0, full = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const bool is_full = IsOverCapacity(plans[i]);
    EXPECT_EQ(findings[i].capacity > 0, is_full) << ToJson(plans[i]);
    full += is_full ? 1 : 0;
    const bool is_close = IsTooClose(plans[i], 0.0);
    if (IsTooClose(plans[i], kDoubtful_m) != is_close ||
        IsTooClose(plans[i], -kDoubtful_m) != is_close) {
      continue;
    }
    EXPECT_EQ(findings[i].separation > 0, is_close) << ToJson(plans[i]);
    ++compared;
    close += is_close ? 1 : 0;
  }
  // Both answers are frequent.
  EXPECT_GT(compared, 350);
  EXPECT_GT(close, 50);
  EXPECT_GT(compared - close, 50);
  EXPECT_GT(full, 50);
  EXPECT_LT(full, 350);
}

}  // namespace
}  // namespace kg_engine
