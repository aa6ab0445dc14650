#include "kg_planner/tours/micro_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

namespace kg_planner {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct StageShape {
  int nodes = 6;
  bool tokens = true;
  bool whole_numbers = false;  // Integer values: many ties.
  double missing = 0.3;
  double limit = 6.0;
};

class RandomStage {
 public:
  RandomStage(const StageShape& shape, unsigned seed)
      : shape_(shape), prng_(seed) {}

  StageProblem Make() {
    StageProblem problem;
    problem.nodes.resize(shape_.nodes);
    for (Node& node : problem.nodes) {
      node.reward = Number(-1.0, 5.0);
      for (int i = shape_.tokens ? Whole(0, 2) : 0; i > 0; --i) {
        node.tokens.push_back({Whole(-1, 2), Number(0.0, 6.0)});
      }
    }
    for (int from = -1; from < shape_.nodes; ++from) {
      for (int to = 0; to < shape_.nodes; ++to) {
        if (from == to || Number(0.0, 1.0) < shape_.missing) continue;
        problem.legs.push_back(
            {from, to, Number(0.0, 2.0), Number(0.0, 3.0), Number(0.0, 3.0)});
      }
    }
    std::shuffle(problem.legs.begin(), problem.legs.end(), prng_);
    problem.duration_limit = Number(0.0, shape_.limit);
    return problem;
  }

 private:
  int Whole(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(prng_);
  }
  double Number(double low, double high) {
    if (shape_.whole_numbers) {
      return Whole(static_cast<int>(low), static_cast<int>(high));
    }
    return std::uniform_real_distribution<double>(low, high)(prng_);
  }

  StageShape shape_;
  std::mt19937 prng_;
};

// All paths within the limits, by exhaustive search.
class ExhaustiveSearch {
 public:
  ExhaustiveSearch(const StageProblem& problem, int max_nodes)
      : problem_(problem), max_nodes_(max_nodes) {
    Extend({}, -1);
  }
  const std::vector<MicroPath>& paths() const { return paths_; }

  MicroPath Priced(const std::vector<int>& nodes) const {
    MicroPath path;
    path.nodes = nodes;
    int at = -1;
    for (int node : nodes) {
      const Leg* leg = Find(at, node);
      path.cost += leg->cost;
      path.resource += leg->resource;
      path.duration += leg->duration;
      at = node;
    }
    std::map<int, double> tokens;
    for (int node : nodes) {
      path.reward += problem_.nodes[node].reward;
      for (const TokenReward& token : problem_.nodes[node].tokens) {
        tokens[token.token] = std::max(tokens[token.token], token.reward);
      }
    }
    for (const auto& [token, reward] : tokens) path.reward += reward;
    return path;
  }

  const Leg* Find(int from, int to) const {
    for (const Leg& leg : problem_.legs) {
      if (leg.from == from && leg.to == to) return &leg;
    }
    return nullptr;
  }

 private:
  void Extend(const std::vector<int>& nodes, int at) {
    if (static_cast<int>(nodes.size()) == max_nodes_) return;
    for (const Leg& leg : problem_.legs) {
      if (leg.from != at) continue;
      if (std::count(nodes.begin(), nodes.end(), leg.to) > 0) continue;
      std::vector<int> longer = nodes;
      longer.push_back(leg.to);
      const MicroPath path = Priced(longer);
      if (!(path.duration <= problem_.duration_limit)) continue;
      paths_.push_back(path);
      Extend(longer, leg.to);
    }
  }

  const StageProblem& problem_;
  const int max_nodes_;
  std::vector<MicroPath> paths_;
};

using SetAndEnd = std::pair<std::set<int>, int>;
SetAndEnd KeyOf(const MicroPath& path) {
  return {{path.nodes.begin(), path.nodes.end()}, path.nodes.back()};
}

// Scores of the sets that reach each end, best first.
std::map<int, std::vector<double>> ScoresByEnd(
    const std::vector<MicroPath>& paths) {
  std::map<SetAndEnd, double> best;
  for (const MicroPath& path : paths) {
    const auto [it, isNew] = best.emplace(KeyOf(path), path.score());
    if (!isNew) it->second = std::max(it->second, path.score());
  }
  std::map<int, std::vector<double>> scores;
  for (const auto& [key, score] : best) scores[key.second].push_back(score);
  for (auto& [end, values] : scores) {
    std::sort(values.begin(), values.end(), std::greater<>());
  }
  return scores;
}

// Invariants of every result, proven or not.
void ExpectValid(const MicroPaths& found, const StageProblem& problem,
                 const MicroPathOptions& options) {
  const ExhaustiveSearch reference(problem, 1);
  std::set<SetAndEnd> seen;
  std::set<int> direct;
  for (const MicroPath& path : found.paths) {
    ASSERT_FALSE(path.nodes.empty());
    ASSERT_LE(static_cast<int>(path.nodes.size()), options.max_nodes);
    const std::set<int> set(path.nodes.begin(), path.nodes.end());
    EXPECT_EQ(set.size(), path.nodes.size()) << "a node twice";
    EXPECT_TRUE(seen.insert(KeyOf(path)).second) << "a set twice";
    int at = -1;
    for (int node : path.nodes) {
      ASSERT_NE(reference.Find(at, node), nullptr);
      at = node;
    }
    const MicroPath priced = reference.Priced(path.nodes);
    EXPECT_DOUBLE_EQ(path.cost, priced.cost);
    EXPECT_DOUBLE_EQ(path.resource, priced.resource);
    EXPECT_DOUBLE_EQ(path.duration, priced.duration);
    EXPECT_NEAR(path.reward, priced.reward, 1e-9);
    EXPECT_LE(path.duration, problem.duration_limit);
    if (path.nodes.size() == 1) direct.insert(path.nodes[0]);
  }
  for (const MicroPath& path : reference.paths()) {
    EXPECT_EQ(direct.count(path.nodes[0]), 1u) << "no direct leg";
  }
}

// Paths kept for an end, without an additional direct leg.
std::vector<double> Alternatives(const MicroPaths& found, int end,
                                 const MicroPathOptions& options) {
  std::vector<double> scores;
  for (const MicroPath& path : found.paths) {
    if (path.nodes.back() == end) scores.push_back(path.score());
  }
  EXPECT_TRUE(std::is_sorted(scores.rbegin(), scores.rend()));
  const double min_value =
      scores[0] - (1.0 - options.good_enough) * std::abs(scores[0]);
  while (static_cast<int>(scores.size()) > options.per_end ||
         scores.back() < min_value) {
    scores.pop_back();
  }
  return scores;
}

MicroPathOptions RandomOptions(unsigned seed) {
  MicroPathOptions options;
  options.per_end = 1 + seed % 4;
  options.good_enough = 0.25 * (seed % 5);
  options.max_nodes = 1 + seed % 6;
  return options;
}

TEST(MicroPaths, EqualsExhaustionOnRandomStages) {
  std::size_t compared = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    StageShape shape;
    shape.nodes = 1 + seed % 6;
    shape.tokens = seed % 2 == 0;
    shape.whole_numbers = seed % 3 == 0;
    const StageProblem problem = RandomStage(shape, seed).Make();
    const MicroPathOptions options = RandomOptions(seed);
    const MicroPaths found = FindMicroPaths(problem, options);
    EXPECT_TRUE(found.proven);
    ExpectValid(found, problem, options);
    const ExhaustiveSearch all(problem, options.max_nodes);
    std::set<int> ends;
    for (const MicroPath& path : found.paths) ends.insert(path.nodes.back());
    const auto expected = ScoresByEnd(all.paths());
    ASSERT_EQ(ends.size(), expected.size()) << "seed " << seed;
    for (const auto& [end, scores] : expected) {
      const auto kept = Alternatives(found, end, options);
      const double min_value =
          scores[0] - (1.0 - options.good_enough) * std::abs(scores[0]);
      std::size_t wanted = 0;
      while (wanted < scores.size() && scores[wanted] >= min_value - 1e-9 &&
             static_cast<int>(wanted) < options.per_end) {
        ++wanted;
      }
      ASSERT_EQ(kept.size(), wanted) << "seed " << seed << " end " << end;
      for (std::size_t i = 0; i < wanted; ++i) {
        EXPECT_NEAR(kept[i], scores[i], 1e-9) << "seed " << seed;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 3000u);
}

TEST(MicroPaths, SearchBeyondTheLabelsComesClose) {
  double reached = 0.0;
  double possible = 0.0;
  int best_found = 0;
  int ends = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    StageShape shape;
    shape.nodes = 7;
    shape.missing = 0.1;
    shape.limit = 8.0;
    const StageProblem problem = RandomStage(shape, seed).Make();
    MicroPathOptions options;
    options.max_nodes = 6;
    options.exact_labels = 6;
    options.max_steps = 1000;
    const MicroPaths found = FindMicroPaths(problem, options);
    options.exact_labels = 100000;
    const MicroPaths exact = FindMicroPaths(problem, options);
    ASSERT_TRUE(exact.proven);
    ExpectValid(found, problem, options);
    std::map<int, double> best;
    for (const MicroPath& path : found.paths) {
      best.emplace(path.nodes.back(), path.score());
    }
    std::set<int> seen;
    for (const MicroPath& path : exact.paths) {
      if (!seen.insert(path.nodes.back()).second) continue;
      ++ends;
      possible += path.score();
      if (best.count(path.nodes.back()) == 0) continue;
      EXPECT_LE(best[path.nodes.back()], path.score() + 1e-9);
      reached += best[path.nodes.back()];
      if (best[path.nodes.back()] > path.score() - 1e-9) ++best_found;
    }
  }
  EXPECT_GE(reached, 0.995 * possible);
  EXPECT_GE(best_found, 0.97 * ends);
}

// Points in a square, no more than an hour and a half apart.
StageProblem LargeStage(int nodes) {
  std::mt19937 prng(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  StageProblem problem;
  problem.nodes.resize(nodes);
  std::vector<double> x{0.5}, y{0.5};
  for (Node& node : problem.nodes) {
    node.reward = unit(prng);
    x.push_back(unit(prng));
    y.push_back(unit(prng));
  }
  for (int from = -1; from < nodes; ++from) {
    for (int to = 0; to < nodes; ++to) {
      if (from == to) continue;
      const double d =
          std::hypot(x[from + 1] - x[to + 1], y[from + 1] - y[to + 1]);
      problem.legs.push_back({from, to, 0.1 * d, d, d});
    }
  }
  problem.duration_limit = 1.5;
  return problem;
}

double SumOfBest(const MicroPaths& found) {
  double sum = 0.0;
  std::set<int> seen;
  for (const MicroPath& path : found.paths) {
    if (seen.insert(path.nodes.back()).second) sum += path.score();
  }
  return sum;
}

TEST(MicroPaths, IsTheSameForTheSameSeedAndBetterWithMoreSteps) {
  const StageProblem problem = LargeStage(40);
  MicroPathOptions options;
  options.max_nodes = 12;
  options.max_steps = 0;
  const MicroPaths beam = FindMicroPaths(problem, options);
  options.max_steps = 800;
  const MicroPaths first = FindMicroPaths(problem, options);
  const MicroPaths again = FindMicroPaths(problem, options);
  EXPECT_FALSE(first.proven);
  ExpectValid(first, problem, options);
  EXPECT_GT(SumOfBest(first), SumOfBest(beam));
  ASSERT_EQ(first.paths.size(), again.paths.size());
  for (std::size_t i = 0; i < first.paths.size(); ++i) {
    EXPECT_EQ(first.paths[i].nodes, again.paths[i].nodes);
    EXPECT_EQ(first.paths[i].score(), again.paths[i].score());
  }
}

TEST(MicroPaths, GivesTheDirectLegsAtADeadlineThatIsOver) {
  const StageProblem problem = LargeStage(30);
  MicroPathOptions options;
  options.deadline_s = 0.0;
  const MicroPaths found = FindMicroPaths(problem, options);
  EXPECT_FALSE(found.proven);
  ExpectValid(found, problem, options);
}

StageProblem TwoNodes() {
  StageProblem problem;
  problem.nodes = {{1.0, {}}, {1.0, {}}};
  problem.legs = {{-1, 0, 0, 0, 1.0},
                  {-1, 1, 0, 0, 1.0},
                  {0, 1, 0, 0, 0.5},
                  {1, 0, 0, 0, 0.5}};
  problem.duration_limit = 2.0;
  return problem;
}

TEST(MicroPaths, IsTheHeadersExample) {
  const MicroPaths found = FindMicroPaths(TwoNodes(), {});
  ASSERT_EQ(found.paths.size(), 4u);
  EXPECT_EQ(found.paths[0].nodes, (std::vector<int>{1, 0}));
  EXPECT_EQ(found.paths[1].nodes, (std::vector<int>{0}));
  EXPECT_EQ(found.paths[2].nodes, (std::vector<int>{0, 1}));
  EXPECT_EQ(found.paths[3].nodes, (std::vector<int>{1}));
}

TEST(MicroPaths, EarnsATokenOnce) {
  StageProblem problem = TwoNodes();
  problem.nodes = {{0.0, {{5, 2.0}}}, {0.0, {{5, 3.0}}}};
  const MicroPaths found = FindMicroPaths(problem, {});
  EXPECT_EQ(found.paths[0].reward, 3.0);
}

TEST(MicroPaths, EndsExactlyAtTheLimit) {
  StageProblem problem = TwoNodes();
  problem.duration_limit = 1.5;
  EXPECT_EQ(FindMicroPaths(problem, {}).paths.size(), 4u);
  problem.duration_limit = std::nextafter(1.5, 0.0);
  EXPECT_EQ(FindMicroPaths(problem, {}).paths.size(), 2u);
  problem.duration_limit = 0.0;
  EXPECT_TRUE(FindMicroPaths(problem, {}).paths.empty());
  problem.duration_limit = kInfinity;
  EXPECT_EQ(FindMicroPaths(problem, {}).paths.size(), 4u);
}

TEST(MicroPaths, ReachesANodeThatNoDirectLegReaches) {
  StageProblem problem = TwoNodes();
  problem.legs.erase(problem.legs.begin() + 1);
  const MicroPaths found = FindMicroPaths(problem, {});
  ASSERT_EQ(found.paths.size(), 2u);
  EXPECT_EQ(found.paths[1].nodes, (std::vector<int>{0, 1}));
}

TEST(MicroPaths, OfNothingIsNothing) {
  const MicroPaths found = FindMicroPaths({}, {});
  EXPECT_TRUE(found.paths.empty());
  EXPECT_TRUE(found.proven);
}

template <typename Change>
void ExpectRefused(const Change& change) {
  StageProblem problem = TwoNodes();
  MicroPathOptions options;
  change(&problem, &options);
  EXPECT_THROW(FindMicroPaths(problem, options), std::invalid_argument);
}

TEST(MicroPaths, RefusesWhatIsNoStage) {
  using P = StageProblem;
  using O = MicroPathOptions;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRefused([](P* p, O*) { p->legs[0].to = 2; });
  ExpectRefused([](P* p, O*) { p->legs[0].to = -1; });
  ExpectRefused([](P* p, O*) { p->legs[0].from = -2; });
  ExpectRefused([](P* p, O*) { p->legs[2].from = 1; });
  ExpectRefused([](P* p, O*) { p->legs[1] = p->legs[0]; });
  ExpectRefused([](P* p, O*) { p->legs[0].cost = -1.0; });
  ExpectRefused([](P* p, O*) { p->legs[0].resource = kInfinity; });
  ExpectRefused([=](P* p, O*) { p->legs[0].duration = nan; });
  ExpectRefused([=](P* p, O*) { p->nodes[0].reward = nan; });
  ExpectRefused([](P* p, O*) { p->nodes[0].tokens = {{0, -1.0}}; });
  ExpectRefused([=](P* p, O*) { p->duration_limit = nan; });
  ExpectRefused([](P*, O* o) { o->per_end = 0; });
  ExpectRefused([](P*, O* o) { o->max_nodes = 0; });
  ExpectRefused([](P*, O* o) { o->good_enough = 1.5; });
  ExpectRefused([=](P*, O* o) { o->deadline_s = nan; });
}

}  // namespace
}  // namespace kg_planner
