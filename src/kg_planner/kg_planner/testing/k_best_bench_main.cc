// Benchmark: the K best paths of a dense trellis, and K diverse ones, against
// one Viterbi pass over the same seams and against list Viterbi, alternating in
// one process.
//
//   k_best_bench [--quick]
//
// The Viterbi pass is the plain forward recursion for the best score only: it
// reads every seam once, checks nothing, keeps no back pointers, and is
// memory-bound at this size. Rewards and costs are multiples of 2^-30, so that
// all sums are exact and scores can be compared bitwise.
//
// Prints one line per target: goal, measured (median of the rounds), met or
// missed.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "kg_base/common/testing/bench_report.h"
#include "kg_planner/k_best/diverse_paths.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_planner/testing/list_viterbi.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {
namespace {

using kg_base::Median;
using kg_base::Milliseconds;
using kg_base::Report;

struct BenchCase {
  int nodes;
  int stages;
  int paths;
  std::string Name() const {
    return std::to_string(nodes) + " nodes, " + std::to_string(stages) +
           " stages, K=" + std::to_string(paths);
  }
};

Trellis DenseTrellis(const BenchCase& one, unsigned seed) {
  std::mt19937 prng(seed);
  const auto share = [&] { return static_cast<double>(prng() >> 2) * 0x1p-30; };
  Trellis trellis;
  trellis.stages.resize(one.stages);
  int before = 1;
  for (Stage& stage : trellis.stages) {
    stage.nodes.resize(one.nodes);
    for (Node& node : stage.nodes) node.reward = share();
    for (int from = 0; from < before; ++from) {
      for (int to = 0; to < one.nodes; ++to) {
        stage.seams.push_back({from, to, 0.5 * share(), 0.0});
      }
    }
    before = one.nodes;
  }
  return trellis;
}

double Viterbi(const Trellis& trellis) {
  std::vector<double> best{0.0};
  for (const Stage& stage : trellis.stages) {
    std::vector<double> next(stage.nodes.size(), -1e300);
    for (const Seam& seam : stage.seams) {
      next[seam.to] = std::max(next[seam.to], best[seam.from] - seam.cost);
    }
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] += stage.nodes[i].reward;
    }
    best = std::move(next);
  }
  return *std::max_element(best.begin(), best.end());
}

// Number of the K best scores that differ bitwise.
int CountDifferent(const std::vector<Path>& paths,
                   const std::vector<double>& scores) {
  int different =
      static_cast<int>(scores.size()) - static_cast<int>(paths.size());
  for (std::size_t i = 0; i < std::min(paths.size(), scores.size()); ++i) {
    different += paths[i].score() != scores[i];
  }
  return different;
}

struct BenchTimes {
  std::vector<double> in_viterbis;
  std::vector<double> list_in_k_bests;
  std::vector<double> k_best_ms;
  int different = 0;
};

BenchTimes TimeKBest(const Trellis& trellis, const BenchCase& one, int rounds) {
  BenchTimes times;
  for (int i = 0; i < rounds; ++i) {
    KBest found;
    std::vector<double> scores;
    double best = 0.0;
    const double viterbi_ms = Milliseconds([&] { best = Viterbi(trellis); });
    times.k_best_ms.push_back(
        Milliseconds([&] { found = FindKBest(trellis, {}, {one.paths}); }));
    const double list_ms = Milliseconds(
        [&] { scores = ListViterbi(trellis, one.paths).Scores(); });
    times.in_viterbis.push_back(times.k_best_ms.back() / viterbi_ms);
    times.list_in_k_bests.push_back(list_ms / times.k_best_ms.back());
    times.different += CountDifferent(found.paths, scores);
    times.different += found.paths.at(0).score() != best;
  }
  return times;
}

void MeasureKBest(const Trellis& trellis, const BenchCase& one, int rounds,
                  bool is_target) {
  const BenchTimes times = TimeKBest(trellis, one, rounds);
  const double passes = Median(times.in_viterbis);
  const double faster = Median(times.list_in_k_bests);
  if (!is_target) {
    std::printf(
        "K best, %s: %.3f ms, %.3g Viterbi passes, %.3g x faster than "
        "list Viterbi, %d scores differ\n",
        one.Name().c_str(), Median(times.k_best_ms), passes, faster,
        times.different);
    return;
  }
  Report({8, "K best in Viterbi passes, " + one.Name(), 2.5, false, "x"},
         passes);
  Report({8, "list Viterbi against K best, " + one.Name(), 25.0, true, "x"},
         faster);
  Report({8, "scores unlike list Viterbi's, " + one.Name(), 0.0, false, ""},
         times.different);
}

double MeanDifference(const std::vector<Path>& paths) {
  double sum = 0.0;
  int pairs = 0;
  for (std::size_t a = 0; a < paths.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b, ++pairs) {
      for (std::size_t s = 0; s < paths[a].nodes.size(); ++s) {
        sum += paths[a].nodes[s] != paths[b].nodes[s];
      }
    }
  }
  return pairs == 0 ? 0.0 : sum / pairs;
}

// A quarter of the stages must differ; on average half of them do.
void MeasureDiverse(const Trellis& trellis, const BenchCase& one, int rounds) {
  // Timed in turn with a plain Viterbi pass, so that load on the machine
  // touches both alike.
  KBest found;
  std::vector<double> passes;
  for (int i = 0; i < rounds; ++i) {
    const double viterbi_ms = Milliseconds([&] { Viterbi(trellis); });
    const double diverse_ms = Milliseconds([&] {
      found = FindDiverse(trellis, {}, {one.paths, one.stages / 4, 0.99});
    });
    passes.push_back(diverse_ms / viterbi_ms);
  }
  const KBest k_best = FindKBest(trellis, {}, {one.paths});
  std::printf(
      "%zu of %d paths differ in %d stages or more; the K best in %.1f "
      "on the average\n",
      found.paths.size(), one.paths, one.stages / 4,
      MeanDifference(k_best.paths));
  Report(
      {9, "mean difference of diverse paths, " + one.Name(), 50.0, true, "%"},
      100.0 * MeanDifference(found.paths) / one.stages);
  Report({9, "worst diverse path against the best, " + one.Name(), 99.0, true,
          "%"},
         100.0 * found.paths.back().score() / found.paths.front().score());
  Report(
      {9, "diverse paths in Viterbi passes, " + one.Name(), 12.0, false, "x"},
      Median(passes));
}

}  // namespace
}  // namespace kg_planner

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int rounds = quick ? 1 : 11;
  for (const kg_planner::BenchCase& one :
       {kg_planner::BenchCase{20, 7, 50}, kg_planner::BenchCase{20, 7, 1000},
        kg_planner::BenchCase{100, 28, 100},
        kg_planner::BenchCase{200, 168, 100}}) {
    const kg_planner::Trellis trellis = kg_planner::DenseTrellis(one, 42);
    const bool is_target = one.nodes == 200;
    kg_planner::MeasureKBest(trellis, one, rounds, is_target);
    if (is_target) kg_planner::MeasureDiverse(trellis, one, rounds);
  }
  return EXIT_SUCCESS;
}
