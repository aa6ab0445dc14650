#include "kg_planner/tours/orienteering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "kg_planner/tours/tour_search.h"

namespace kg_planner {
namespace {

struct ProblemShape {
  int points = 7;  // Start and end included.
  int tours = 1;
  bool plane = true;  // False: arbitrary, asymmetric lengths.
  bool negative = false;
};

OrienteeringProblem RandomProblem(const ProblemShape& shape, unsigned seed) {
  std::mt19937 prng(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  OrienteeringProblem problem;
  std::vector<double> x, y;
  for (int i = 0; i < shape.points; ++i) {
    x.push_back(unit(prng));
    y.push_back(unit(prng));
    problem.rewards.push_back(std::floor(10.0 * unit(prng)) -
                              (shape.negative ? 3.0 : 0.0));
  }
  problem.rewards.front() = problem.rewards.back() = 0.0;
  for (int i = 0; i < shape.points; ++i) {
    for (int j = 0; j < shape.points; ++j) {
      problem.lengths.push_back(
          shape.plane ? std::hypot(x[i] - x[j], y[i] - y[j]) : unit(prng));
    }
  }
  problem.limit = 0.2 + 2.0 * unit(prng);
  problem.tours = shape.tours;
  return problem;
}

// Every point set that one tour can visit, by exhaustive search.
class ExhaustiveSearch {
 public:
  explicit ExhaustiveSearch(const OrienteeringProblem& problem)
      : problem_(problem), possible_(std::size_t{1} << problem.size(), false) {
    Go(0, 0.0, 0);
  }

  // Best reward of `tours` tours that share no point.
  double Best(int tours) const { return Best(tours, 0); }

 private:
  void Go(int at, double length, unsigned set) {
    const int last = problem_.size() - 1;
    if (length + problem_.length(at, last) <= problem_.limit) {
      possible_[set] = true;
    }
    for (int p = 1; p < last; ++p) {
      if ((set >> p & 1u) != 0) continue;
      const double longer = length + problem_.length(at, p);
      if (longer <= problem_.limit) Go(p, longer, set | 1u << p);
    }
  }
  double TotalReward(unsigned set) const {
    double reward = 0.0;
    for (int p = 0; p < problem_.size(); ++p) {
      if ((set >> p & 1u) != 0) reward += problem_.rewards[p];
    }
    return reward;
  }
  double Best(int tours, unsigned taken) const {
    if (tours == 0) return 0.0;
    double best = 0.0;
    for (unsigned set = 0; set < possible_.size(); ++set) {
      if (!possible_[set] || (set & taken) != 0) continue;
      best = std::max(best, TotalReward(set) + Best(tours - 1, taken | set));
    }
    return best;
  }

  const OrienteeringProblem& problem_;
  std::vector<bool> possible_;  // Feasibility by point set.
};

void ExpectValid(const OrienteeringProblem& problem,
                 const std::vector<Tour>& tours) {
  std::set<int> seen;
  for (const Tour& tour : tours) {
    if (tour.points.empty()) continue;
    const Tour made = MakeTour(problem, tour.points);
    EXPECT_EQ(tour.reward, made.reward);
    EXPECT_EQ(tour.length, made.length);
    EXPECT_LE(made.length, problem.limit);
    for (int p : tour.points) {
      EXPECT_TRUE(p > 0 && p + 1 < problem.size());
      EXPECT_TRUE(seen.insert(p).second) << "point " << p << " twice";
    }
  }
}

TEST(FindExactTour, EqualsExhaustion) {
  int interesting = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    ProblemShape shape;
    shape.points = 2 + seed % 8;
    shape.negative = seed % 2 == 0;
    const OrienteeringProblem problem = RandomProblem(shape, seed);
    const auto found = FindExactTour(problem, 1000000);
    ASSERT_EQ(found.has_value(), IsPossible(problem)) << "seed " << seed;
    if (!found) continue;
    EXPECT_TRUE(found->proven);
    ExpectValid(problem, {found->tour});
    EXPECT_EQ(found->tour.reward, ExhaustiveSearch(problem).Best(1)) << seed;
    EXPECT_EQ(found->bound, found->tour.reward);
    if (found->tour.points.size() > 1) ++interesting;
  }
  EXPECT_GT(interesting, 300);
}

TEST(FindExactTour, SaysWhenItGaveUp) {
  ProblemShape shape;
  shape.points = 14;
  OrienteeringProblem problem = RandomProblem(shape, 5);
  problem.limit = 2.0;
  TourSearch search(problem, 1);
  search.Run(100, 0.0);
  const Tour known = search.best()[0];
  const auto found = FindExactTour(problem, 10, known);
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->proven);
  EXPECT_GE(found->tour.reward, known.reward);
  EXPECT_GE(found->bound, FindExactTour(problem, 1000000)->tour.reward);
}

TEST(FindExactTour, ProvesNothingWhereDetoursAreShortCuts) {
  ProblemShape shape;
  shape.plane = false;
  OrienteeringProblem problem = RandomProblem(shape, 2);
  problem.limit = 2.0;
  const auto found = FindExactTour(problem, 1000000);
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->proven);
  EXPECT_GE(found->bound, ExhaustiveSearch(problem).Best(1));
}

TEST(TourSearch, FindsTheOptimumOfSmallProblems) {
  int optimal = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    ProblemShape shape;
    shape.points = 2 + seed % 6;
    shape.tours = 1 + seed % 3;
    shape.negative = seed % 2 == 0;
    const OrienteeringProblem problem = RandomProblem(shape, seed);
    TourSearch search(problem, seed);
    search.Run(100, 1.0);
    ExpectValid(problem, search.best());
    const double best = IsPossible(problem)
                            ? ExhaustiveSearch(problem).Best(problem.tours)
                            : 0.0;
    double sum = 0.0;
    for (const Tour& tour : search.best()) sum += tour.reward;
    EXPECT_EQ(sum, search.reward());
    EXPECT_LE(sum, best);
    if (sum == best) ++optimal;
  }
  EXPECT_GE(optimal, 998);
}

TEST(TourSearch, KeepsToLengthsThatAreNotOfAPlane) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    ProblemShape shape;
    shape.points = 15;
    shape.tours = 2;
    shape.plane = false;
    const OrienteeringProblem problem = RandomProblem(shape, seed);
    TourSearch search(problem, seed);
    search.Run(50, 1.0);
    ExpectValid(problem, search.best());
  }
}

OrienteeringProblem LargeProblem() {
  ProblemShape shape;
  shape.points = 60;
  shape.tours = 3;
  return RandomProblem(shape, 11);
}

TEST(TourSearch, IsTheSameForTheSameSeed) {
  const OrienteeringProblem problem = LargeProblem();
  TourSearch a(problem, 3);
  TourSearch b(problem, 3);
  a.Run(200, 2.0);
  b.Run(120, 2.0);
  b.Run(80, 2.0);
  ASSERT_EQ(a.best().size(), b.best().size());
  for (std::size_t t = 0; t < a.best().size(); ++t) {
    EXPECT_EQ(a.best()[t].points, b.best()[t].points);
  }
  const auto pool_a = a.pool(50);
  const auto pool_b = b.pool(50);
  ASSERT_EQ(pool_a.size(), pool_b.size());
  for (std::size_t i = 0; i < pool_a.size(); ++i) {
    EXPECT_EQ(pool_a[i].tour.points, pool_b[i].tour.points);
  }
}

TEST(TourSearch, PoolsToursThatKeepTheLimit) {
  const OrienteeringProblem problem = LargeProblem();
  TourSearch search(problem, 1);
  search.Run(500, 5.0);
  const auto pool = search.pool(1000);
  EXPECT_GT(pool.size(), 50u);
  std::set<std::set<int>> sets;
  for (const PooledTour& pooled : pool) {
    ExpectValid(problem, {pooled.tour});
    EXPECT_LE(pooled.context, search.reward());
    EXPECT_GE(pooled.context, pooled.tour.reward);
    EXPECT_TRUE(
        sets.insert({pooled.tour.points.begin(), pooled.tour.points.end()})
            .second);
  }
  EXPECT_EQ(search.pool(7).size(), 7u);
}

TEST(TourSearch, StartsFromTheGivenTour) {
  const OrienteeringProblem problem = LargeProblem();
  TourSearch good(problem, 1);
  good.Run(500, 1.0);
  TourSearch other(problem, 2);
  other.Restart(good.best());
  EXPECT_GE(other.reward(), good.reward());
}

TEST(Orienteering, RefusesWhatIsNoProblem) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(OrienteeringProblem*)>> damages = {
      [](OrienteeringProblem* p) { p->rewards.resize(1); },
      [](OrienteeringProblem* p) { p->lengths.pop_back(); },
      [](OrienteeringProblem* p) { p->tours = 0; },
      [=](OrienteeringProblem* p) { p->limit = nan; },
      [](OrienteeringProblem* p) { p->limit = -1.0; },
      [=](OrienteeringProblem* p) { p->rewards[1] = nan; },
      [](OrienteeringProblem* p) { p->lengths[3] = -1.0; },
      [=](OrienteeringProblem* p) { p->lengths[3] = nan; },
  };
  for (const auto& damage : damages) {
    OrienteeringProblem problem = RandomProblem({}, 1);
    Check(problem);
    damage(&problem);
    EXPECT_THROW(Check(problem), std::invalid_argument);
    EXPECT_THROW(TourSearch(problem, 1), std::invalid_argument);
    EXPECT_THROW(FindExactTour(problem, 10), std::invalid_argument);
  }
}

}  // namespace
}  // namespace kg_planner
