#include "kg_selector/packing/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace kg_selector {
namespace {

class RandomPacking {
 public:
  explicit RandomPacking(unsigned seed) : prng_(seed) {}

  // `whole`: integer scores, so there are ties.
  Packing Make(int columns, bool distinct, bool whole) {
    Packing packing;
    for (int a = Whole(1, 4); a > 0; --a) {
      packing.agent_counts.push_back(distinct ? 1 : Whole(0, 3));
    }
    for (int r = Whole(0, 6); r > 0; --r) {
      packing.row_capacities.push_back(Whole(Whole(0, 9) == 0 ? 0 : 1, 2));
    }
    for (int c = 0; c < columns; ++c) {
      packing.columns.push_back(MakeColumn(packing, whole));
    }
    for (int i = Whole(0, columns); i > 0 && columns > 1; --i) {
      const int a = Whole(0, columns - 1);
      const int b = Whole(0, columns - 1);
      if (a != b) packing.conflicts.push_back({a, b});
    }
    return packing;
  }

  int Whole(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(prng_);
  }
  double Number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(prng_);
  }

 private:
  Column MakeColumn(const Packing& packing, bool whole) {
    Column column;
    column.agent = Whole(0, static_cast<int>(packing.agent_counts.size()) - 1);
    column.score = whole ? Whole(-1, 6) : Number(-1.0, 6.0);
    column.load = whole ? Whole(-1, 4) : Number(-0.5, 4.0);
    for (int r = 0; r < static_cast<int>(packing.row_capacities.size()); ++r) {
      if (Whole(0, 2) == 0) column.rows.push_back(r);
    }
    return column;
  }

  std::mt19937 prng_;
};

// Independent implementation, for comparison.
bool IsAllowed(const Packing& packing, unsigned set) {
  std::map<int, int> agents;
  std::map<int, int> rows;
  for (std::size_t c = 0; c < packing.columns.size(); ++c) {
    if ((set >> c & 1u) == 0) continue;
    ++agents[packing.columns[c].agent];
    for (int row : packing.columns[c].rows) ++rows[row];
  }
  for (const auto& [agent, count] : agents) {
    if (count > packing.agent_counts[agent]) return false;
  }
  for (const auto& [row, count] : rows) {
    if (count > packing.row_capacities[row]) return false;
  }
  for (const auto& [a, b] : packing.conflicts) {
    if ((set >> a & 1u) != 0 && (set >> b & 1u) != 0) return false;
  }
  return true;
}

struct PackingValue {
  double score = 0.0;
  double min_value = 0.0;
  double largest = 0.0;
};
PackingValue TotalReward(const Packing& packing, unsigned set) {
  std::map<int, double> loads;
  PackingValue value;
  for (const Column& column : packing.columns) loads[column.agent] = 0.0;
  for (std::size_t c = 0; c < packing.columns.size(); ++c) {
    if ((set >> c & 1u) == 0) continue;
    value.score += packing.columns[c].score;
    loads[packing.columns[c].agent] += packing.columns[c].load;
  }
  value.min_value = value.largest = loads.begin()->second;
  for (const auto& [agent, load] : loads) {
    value.min_value = std::min(value.min_value, load);
    value.largest = std::max(value.largest, load);
  }
  return value;
}

unsigned SetName(const std::vector<int>& chosen) {
  unsigned set = 0;
  for (int c : chosen) set |= 1u << c;
  return set;
}

// Exhaustive search for the lexicographically best `key`.
template <typename Key>
std::pair<double, double> Best(const Packing& packing, const Key& key) {
  std::pair<double, double> best{-1e300, -1e300};
  for (unsigned set = 0; set < (1u << packing.columns.size()); ++set) {
    if (IsAllowed(packing, set)) {
      best = std::max(best, key(TotalReward(packing, set)));
    }
  }
  return best;
}

TEST(Packing, EqualsExhaustion) {
  int more_than_quick = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    RandomPacking random(seed);
    const Packing packing =
        random.Make(random.Whole(1, 11), seed % 2 == 0, seed % 3 == 0);
    const PackingChoice found = SolvePacking(packing, {});
    const double best = Best(packing, [](const PackingValue& v) {
                          return std::make_pair(v.score, 0.0);
                        }).first;
    ASSERT_TRUE(IsAllowed(packing, SetName(found.chosen))) << "seed " << seed;
    EXPECT_TRUE(found.optimal);
    EXPECT_NEAR(found.objective, best, 1e-7) << "seed " << seed;
    EXPECT_EQ(found.objective, found.bound);
    EXPECT_NEAR(TotalReward(packing, SetName(found.chosen)).score, best, 1e-7);
    const double quick = ComputeObjective(packing, PackQuickly(packing, {}));
    EXPECT_LE(quick, best + 1e-9);
    EXPECT_GE(PriceRows(packing).bound, best - 1e-7);
    if (quick < best - 1e-7) ++more_than_quick;
  }
  EXPECT_GT(more_than_quick, 20);
}

TEST(Packing, MakesTheLeastLoadLargestAndThenTheScore) {
  int not_the_best_score = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    RandomPacking random(seed);
    Packing packing = random.Make(random.Whole(1, 10), true, seed % 3 == 0);
    packing.fairness = Fairness::kMaxMin;
    const PackingChoice found = SolvePacking(packing, {});
    const auto best = Best(packing, [](const PackingValue& v) {
      return std::make_pair(v.min_value, v.score);
    });
    ASSERT_TRUE(IsAllowed(packing, SetName(found.chosen))) << "seed " << seed;
    EXPECT_TRUE(found.optimal);
    EXPECT_NEAR(found.min_load, best.first, 1e-9) << "seed " << seed;
    EXPECT_NEAR(found.objective, best.second, 1e-7) << "seed " << seed;
    packing.fairness = Fairness::kNone;
    if (SolvePacking(packing, {}).objective > found.objective + 1e-7) {
      ++not_the_best_score;
    }
  }
  EXPECT_GT(not_the_best_score, 20);
}

TEST(Packing, BalancesLoadsAtTheirWeight) {
  int not_the_best_score = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    RandomPacking random(seed);
    Packing packing = random.Make(random.Whole(1, 10), true, seed % 3 == 0);
    packing.fairness = Fairness::kBalance;
    packing.weight = random.Number(0.0, 2.0);
    const PackingChoice found = SolvePacking(packing, {});
    const double best =
        Best(packing, [&](const PackingValue& v) {
          return std::make_pair(
              v.score - packing.weight * (v.largest - v.min_value), 0.0);
        }).first;
    ASSERT_TRUE(IsAllowed(packing, SetName(found.chosen))) << "seed " << seed;
    EXPECT_TRUE(found.optimal);
    EXPECT_NEAR(found.objective, best, 1e-6) << "seed " << seed;
    packing.fairness = Fairness::kNone;
    const double score = SolvePacking(packing, {}).objective;
    if (ComputeObjective(packing, found.chosen) < score - 1e-7) {
      ++not_the_best_score;
    }
  }
  EXPECT_GT(not_the_best_score, 20);
}

// Too large to be solved within the tests' time limits.
Packing HardPacking() {
  RandomPacking random(3);
  Packing packing;
  packing.agent_counts = std::vector<int>(15, 1);
  packing.row_capacities = std::vector<int>(60, 1);
  for (int c = 0; c < 3000; ++c) {
    Column column;
    column.agent = random.Whole(0, 14);
    for (int r = 0; r < 60; ++r) {
      if (random.Whole(0, 9) == 0) column.rows.push_back(r);
    }
    column.score = column.rows.size() + random.Number(0.0, 3.0);
    packing.columns.push_back(column);
  }
  return packing;
}

TEST(Packing, SaysHowFarItMayBeWhenTheTimeIsUp) {
  const Packing packing = HardPacking();
  PackingOptions options;
  options.time_limit_s = 0.0;
  const PackingChoice none = SolvePacking(packing, options);
  EXPECT_FALSE(none.optimal);
  EXPECT_TRUE(IsPacking(packing, none.chosen));
  EXPECT_GE(none.bound, none.objective);
  EXPECT_NEAR(none.bound, PriceRows(packing).bound, 1e-6);
  options.time_limit_s = 0.5;
  options.processor_time = true;
  const PackingChoice some = SolvePacking(packing, options);
  EXPECT_TRUE(IsPacking(packing, some.chosen));
  EXPECT_GE(some.objective, none.objective);
  EXPECT_LE(some.objective, some.bound);
  EXPECT_LE(some.bound, none.bound + 1e-6);
}

TEST(Packing, IsNeverWorseThanItsStart) {
  const Packing packing = HardPacking();
  PackingOptions options;
  options.start = SolvePacking(packing, {0.3}).chosen;
  options.time_limit_s = 0.0;
  EXPECT_GE(SolvePacking(packing, options).objective,
            ComputeObjective(packing, options.start));
}

TEST(Packing, PricesAreWeakDuality) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomPacking random(seed);
    Packing packing = random.Make(12, false, false);
    packing.conflicts.clear();
    const PackingPrices prices = PriceRows(packing);
    double bound = 0.0;
    for (std::size_t a = 0; a < prices.agents.size(); ++a) {
      EXPECT_GE(prices.agents[a], 0.0);
      bound += prices.agents[a] * packing.agent_counts[a];
    }
    for (std::size_t r = 0; r < prices.rows.size(); ++r) {
      EXPECT_GE(prices.rows[r], 0.0);
      bound += prices.rows[r] * packing.row_capacities[r];
    }
    for (const Column& column : packing.columns) {
      double net = column.score - prices.agents[column.agent];
      for (int row : column.rows) net -= prices.rows[row];
      bound += std::max(0.0, net);
    }
    EXPECT_NEAR(bound, prices.bound, 1e-6) << "seed " << seed;
  }
}

TEST(Packing, IsTheHeadersExample) {
  Packing packing;
  packing.agent_counts = {1, 1};
  packing.row_capacities = {1};
  packing.columns = {{0, 5.0, {0}}, {0, 3.0, {}}, {1, 4.0, {0}}};
  EXPECT_EQ(SolvePacking(packing, {}).chosen, (std::vector<int>{1, 2}));
}

TEST(Packing, ChoosesNoColumnOfNegativeScore) {
  Packing packing;
  packing.agent_counts = {1};
  packing.columns = {{0, -1.0, {}}};
  const PackingChoice found = SolvePacking(packing, {});
  EXPECT_TRUE(found.chosen.empty());
  EXPECT_TRUE(found.optimal);
  EXPECT_EQ(found.bound, 0.0);
}

TEST(Packing, OfNothingIsNothing) {
  for (Fairness fairness :
       {Fairness::kNone, Fairness::kMaxMin, Fairness::kBalance}) {
    Packing packing;
    packing.fairness = fairness;
    const PackingChoice found = SolvePacking(packing, {});
    EXPECT_TRUE(found.chosen.empty());
    EXPECT_TRUE(found.optimal);
  }
}

template <typename Change>
void ExpectRefused(const Change& change) {
  Packing packing;
  packing.agent_counts = {1, 1};
  packing.row_capacities = {1};
  packing.columns = {{0, 5.0, {0}}, {1, 4.0, {0}}};
  PackingOptions options;
  change(&packing, &options);
  EXPECT_THROW(SolvePacking(packing, options), std::invalid_argument);
}

TEST(Packing, RefusesWhatIsNoPacking) {
  using P = Packing;
  using O = PackingOptions;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRefused([](P* p, O*) { p->columns[0].agent = 2; });
  ExpectRefused([](P* p, O*) { p->columns[0].rows = {1}; });
  ExpectRefused([](P* p, O*) { p->columns[0].rows = {0, 0}; });
  ExpectRefused([=](P* p, O*) { p->columns[0].score = nan; });
  ExpectRefused([=](P* p, O*) { p->columns[0].load = nan; });
  ExpectRefused([](P* p, O*) { p->agent_counts[0] = -1; });
  ExpectRefused([](P* p, O*) { p->row_capacities[0] = -1; });
  ExpectRefused([](P* p, O*) { p->conflicts = {{0, 0}}; });
  ExpectRefused([](P* p, O*) { p->conflicts = {{0, 2}}; });
  ExpectRefused([=](P* p, O*) { p->weight = nan; });
  ExpectRefused([](P* p, O*) {
    p->fairness = Fairness::kMaxMin;
    p->agent_counts[0] = 2;
  });
  ExpectRefused([](P*, O* o) { o->start = {0, 1}; });
  ExpectRefused([](P*, O* o) { o->start = {2}; });
}

}  // namespace
}  // namespace kg_selector
