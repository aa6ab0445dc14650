#include "kg_selector/orienteering/team_orienteering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_selector/orienteering/top_instance.h"
#include "kg_selector/orienteering/top_report.h"
#include "kg_selector/team/team_modes.h"

namespace kg_selector {
namespace {

using kg_planner::OrienteeringProblem;

TopInstance RandomInstance(int points, int paths, unsigned seed) {
  std::mt19937 prng(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  TopInstance instance;
  instance.paths = paths;
  instance.limit = 0.5 + 2.0 * unit(prng);
  for (int i = 0; i < points; ++i) {
    instance.x.push_back(unit(prng));
    instance.y.push_back(unit(prng));
    instance.scores.push_back(std::floor(10.0 * unit(prng)));
  }
  return instance;
}

// The best team by exhaustive search.
class ExhaustiveSearch {
 public:
  explicit ExhaustiveSearch(const OrienteeringProblem& problem)
      : problem_(problem), possible_(std::size_t{1} << problem.size()) {
    Go(0, 0.0, 0);
  }
  double Best(int tours, unsigned taken = 0) const {
    if (tours == 0) return 0.0;
    double best = 0.0;
    for (unsigned set = 0; set < possible_.size(); ++set) {
      if (!possible_[set] || (set & taken) != 0) continue;
      double reward = 0.0;
      for (int p = 0; p < problem_.size(); ++p) {
        if ((set >> p & 1u) != 0) reward += problem_.rewards[p];
      }
      best = std::max(best, reward + Best(tours - 1, taken | set));
    }
    return best;
  }

 private:
  void Go(int at, double length, unsigned set) {
    const int last = problem_.size() - 1;
    possible_[set] =
        possible_[set] || length + problem_.length(at, last) <= problem_.limit;
    for (int p = 1; p < last; ++p) {
      const double longer = length + problem_.length(at, p);
      if ((set >> p & 1u) == 0 && longer <= problem_.limit) {
        Go(p, longer, set | 1u << p);
      }
    }
  }
  const OrienteeringProblem& problem_;
  std::vector<bool> possible_;
};

TEST(TeamOrienteering, IsWithinOptimumAndBoundInEveryMode) {
  int greedy_misses = 0;
  int bounds = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const OrienteeringProblem problem =
        ToOrienteering(RandomInstance(4 + seed % 5, 2 + seed % 2, seed));
    const double best = kg_planner::IsPossible(problem)
                            ? ExhaustiveSearch(problem).Best(problem.tours)
                            : 0.0;
    for (const TeamMode& mode : TeamModes()) {
      TeamTourOptions options;
      options.planner = mode.plan_tours;
      options.seconds = 0.04;
      const TeamTours team = PlanTours(problem, options);
      EXPECT_EQ(FindFault(problem, team), "") << "seed " << seed;
      EXPECT_LE(team.value, best) << "seed " << seed;
      EXPECT_GE(team.bound, best - 1e-9) << "seed " << seed;
      if (mode.plan_tours == PlanToursExactly) {
        EXPECT_EQ(team.value, best) << "seed " << seed;
      }
      if (mode.plan_tours == PlanToursGreedily && team.value < best) {
        ++greedy_misses;
      }
      if (std::isfinite(team.bound)) ++bounds;
    }
  }
  EXPECT_GE(greedy_misses, 1);
  EXPECT_GT(bounds, 60);
}

TEST(TeamOrienteering, NeedsNoTimeForWhatHasOneAnswer) {
  TopInstance far = RandomInstance(6, 2, 1);
  far.limit = 0.0;
  for (const TeamMode& mode : TeamModes()) {
    TeamTourOptions options;
    options.planner = mode.plan_tours;
    options.seconds = 1000.0;
    const TeamTours none = PlanTours(ToOrienteering(far), options);
    EXPECT_EQ(none.value, 0.0);
    EXPECT_EQ(none.bound, 0.0);
  }
}

TEST(TeamOrienteering, RefusesTimeThatIsNone) {
  const OrienteeringProblem problem = ToOrienteering(RandomInstance(5, 2, 1));
  TeamTourOptions options;
  options.seconds = -1.0;
  EXPECT_THROW(PlanTours(problem, options), std::invalid_argument);
  options.seconds = std::nan("");
  EXPECT_THROW(PlanTours(problem, options), std::invalid_argument);
}

TEST(FaultOf, SeesEveryFault) {
  OrienteeringProblem problem = ToOrienteering(RandomInstance(6, 2, 1));
  problem.limit = 10.0;
  const auto tour = [&](std::vector<int> points) {
    return kg_planner::MakeTour(problem, std::move(points));
  };
  TeamTours team;
  team.tours = {tour({1, 2}), tour({3})};
  team.value = team.tours[0].reward + team.tours[1].reward;
  EXPECT_EQ(FindFault(problem, team), "");
  TeamTours wrong = team;
  wrong.value += 1.0;
  EXPECT_NE(FindFault(problem, wrong).find("value"), std::string::npos);
  wrong = team;
  wrong.tours[1].points = {2};
  EXPECT_NE(FindFault(problem, wrong).find("twice"), std::string::npos);
  wrong = team;
  wrong.tours.push_back({});
  EXPECT_NE(FindFault(problem, wrong).find("more tours"), std::string::npos);
  wrong = team;
  wrong.tours[1].points = {5};
  EXPECT_NE(FindFault(problem, wrong).find("none"), std::string::npos);
  problem.limit = 0.5 * team.tours[0].length;
  EXPECT_NE(FindFault(problem, team).find("above the limit"),
            std::string::npos);
}

class TopFiles : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) {
    const std::string path = (Folder() / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string ErrorOf(const std::string& text) {
    try {
      ReadTopInstance(Write("bad.txt", text));
    } catch (const kg_base::InputError& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path Folder() const { return folder_ / "."; }
  kg_base::TemporaryFolder folder_;
};

constexpr char kSmall[] = "n 3\nm 1\ntmax 4\n0 0 0\n1 0 5\n2 0 0\n";

TEST_F(TopFiles, AreReadWithBlanksTabsAndCarriageReturns) {
  for (const char* text :
       {kSmall, "n\t3\r\nm  1\r\n tmax\t4.0 \r\n\r\n0\t0 0\r\n1 0\t5\r\n2 0 0",
        "n 3\nm 1\ntmax 4\n0 0 0\n1e0 0 5.0\n2 0 0\n\n\n"}) {
    const TopInstance instance = ReadTopInstance(Write("good.txt", text));
    EXPECT_EQ(instance.paths, 1);
    EXPECT_EQ(instance.limit, 4.0);
    EXPECT_EQ(instance.x, (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_EQ(instance.scores, (std::vector<double>{0.0, 5.0, 0.0}));
  }
}

TEST_F(TopFiles, AreRefusedWithFileAndLine) {
  struct Bad {
    const char* text;
    const char* error;
  };
  for (const Bad& bad : std::vector<Bad>{
           {"", "ends too soon, expected 'n <number>'"},
           {"n 3\n", "ends too soon, expected 'm <number>'"},
           {"m 3\n", "bad.txt:1: expected 'n <number>'"},
           {"n three\n", "bad.txt:1: expected n, a number"},
           {"n 1\n", "bad.txt:1: expected n a whole number from 2"},
           {"n 2.5\n", "bad.txt:1: expected n a whole number"},
           {"n 1e99\n", "bad.txt:1: expected n a whole number"},
           {"n 3\n\nm 0\n", "bad.txt:3: expected m a whole number from 1"},
           {"n 2\nm 1\ntmax -1\n", "bad.txt:3: expected tmax not below 0"},
           {"n 2\nm 1\ntmax nan\n", "bad.txt:3: expected tmax, a number"},
           {"n 2\nm 1\ntmax 1\n0 0\n", "bad.txt:4: expected x, y and score"},
           {"n 2\nm 1\ntmax 1\n0 0 x\n", "bad.txt:4: expected score, a number"},
           {"n 2\nm 1\ntmax 1\n0 0 -1\n", "bad.txt:4: expected a score"},
           {"n 2\nm 1\ntmax 1\n0 0 0\n",
            "ends too soon, expected 2 points, found 1"},
           {"n 2\nm 1\ntmax 1\n0 0 0\n0 0 0\n0 0 0\n",
            "bad.txt:6: expected no more than 2 points"}}) {
    EXPECT_NE(ErrorOf(bad.text).find(bad.error), std::string::npos)
        << bad.text << "\ngave: " << ErrorOf(bad.text);
  }
  EXPECT_THROW(ReadTopInstance((Folder() / "none").string()),
               kg_base::InputError);
  EXPECT_THROW(ReadTopReferences(Write("r", "a 1 2\n")), kg_base::InputError);
  EXPECT_THROW(ReadTopReferences(Write("r", "a -1\n")), kg_base::InputError);
  EXPECT_THROW(ReadTopReferences(Write("r", "a 1\na 2\n")),
               kg_base::InputError);
}

TEST_F(TopFiles, AreScoredBySetAndThoseWithoutReferenceNotCounted) {
  Write("s1.a.txt", kSmall);
  Write("s1.b.txt", kSmall);
  Write("s2.a.txt", kSmall);
  Write("s2.b.txt", kSmall);
  const std::string references = Write(
      "references", "s1.a.txt 5\r\ns1.b.txt\t10\r\ns2.a.txt 4\nother 9\n");
  std::ostringstream out;
  const auto sets = RunTop(Folder().string(), references, {}, &out);
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets.at("s1").instances, 2);
  EXPECT_EQ(sets.at("s1").hits, 1);
  EXPECT_EQ(sets.at("s1").above, 0);
  EXPECT_EQ(sets.at("s1").value, 10.0);
  EXPECT_EQ(sets.at("s1").reference, 15.0);
  EXPECT_EQ(sets.at("s1").shares, 1.5);
  EXPECT_EQ(sets.at("s2").above, 1);
  EXPECT_NEAR(sets.at("s2").share(), 125.0, 1e-9);
  EXPECT_NE(out.str().find("s2.b.txt: value 5, no reference, not counted"),
            std::string::npos);
}

std::filesystem::path DataFolder() {
  const char* folder = std::getenv("KG_SHARED_DATA");
  return folder != nullptr ? folder : "../../../shared/data";
}

TEST(TeamOrienteering, ReachesPublishedValuesOfSmallInstances) {
  const auto data = DataFolder() / "top";
  if (!std::filesystem::exists(data)) {
    GTEST_SKIP() << "no benchmark data at " << data;
  }
  const auto references =
      ReadTopReferences((data / "reference_values.txt").string());
  for (const char* name : {"p1.2.i.txt", "p2.2.k.txt", "p3.3.j.txt"}) {
    const OrienteeringProblem problem =
        ToOrienteering(ReadTopInstance((data / "instances" / name).string()));
    TeamTourOptions options;
    options.seconds = 0.3;
    const TeamTours exact = PlanTours(problem, options);
    EXPECT_EQ(FindFault(problem, exact), "");
    EXPECT_EQ(exact.value, references.at(name)) << name;
    for (const TeamMode& mode : TeamModes()) {
      options.planner = mode.plan_tours;
      const TeamTours team = PlanTours(problem, options);
      EXPECT_EQ(FindFault(problem, team), "") << name;
      EXPECT_LE(team.value, exact.value) << name;
      EXPECT_GE(team.bound, exact.value) << name;
    }
  }
}

}  // namespace
}  // namespace kg_selector
