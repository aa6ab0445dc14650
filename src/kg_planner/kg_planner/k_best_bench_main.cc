// Benchmark: the K best paths of a dense trellis against one Viterbi pass over
// the same seams, in turn, in one process.
//
//   k_best_bench [--quick]
//
// Prints a line a target: goal, measured (median of the rounds), met or missed.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "kg_planner/k_best.h"
#include "kg_planner/trellis.h"

namespace kg_planner {
namespace {

struct Case {
  int nodes;
  int stages;
  int paths;
  double goal_passes;  // 0: no goal, for the record.
};

Trellis DenseTrellis(int nodes, int stages, unsigned seed) {
  std::mt19937 prng(seed);
  std::uniform_real_distribution<double> reward(0.0, 1.0);
  std::uniform_real_distribution<double> cost(0.0, 0.5);
  Trellis trellis;
  trellis.stages.resize(stages);
  int before = 1;
  for (Stage& stage : trellis.stages) {
    stage.nodes.resize(nodes);
    for (Node& node : stage.nodes) node.reward = reward(prng);
    for (int from = 0; from < before; ++from) {
      for (int to = 0; to < nodes; ++to) {
        stage.seams.push_back({from, to, cost(prng), 0.0});
      }
    }
    before = nodes;
  }
  return trellis;
}

// The best score alone, by the plain recursion.
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

template <typename Work>
double Milliseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now() - begin)
      .count();
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void Measure(const Case& one, int rounds) {
  const Trellis trellis = DenseTrellis(one.nodes, one.stages, 42);
  KBestOptions options;
  options.paths = one.paths;
  std::vector<double> viterbi_ms;
  std::vector<double> k_best_ms;
  double difference = 0.0;
  for (int i = 0; i < rounds; ++i) {
    double best = 0.0;
    KBest found;
    viterbi_ms.push_back(Milliseconds([&] { best = Viterbi(trellis); }));
    k_best_ms.push_back(
        Milliseconds([&] { found = FindKBest(trellis, {}, options); }));
    difference = std::max(difference, best - found.paths.at(0).score());
  }
  const double passes = Median(k_best_ms) / Median(viterbi_ms);
  std::printf("K best, %d nodes, %d stages, K=%d: ", one.nodes, one.stages,
              one.paths);
  if (one.goal_passes > 0.0) std::printf("goal <= %.1f ", one.goal_passes);
  std::printf(
      "measured %.2f Viterbi passes (%.3f ms / %.3f ms), best score "
      "apart by %.1e",
      passes, Median(k_best_ms), Median(viterbi_ms), difference);
  const bool met = passes <= one.goal_passes;
  std::printf("%s\n",
              one.goal_passes > 0.0 ? (met ? ", met" : ", missed") : "");
}

}  // namespace
}  // namespace kg_planner

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int rounds = quick ? 1 : 11;
  for (const kg_planner::Case& one :
       {kg_planner::Case{20, 7, 50, 0.0}, kg_planner::Case{100, 28, 100, 0.0},
        kg_planner::Case{200, 168, 100, 2.5}}) {
    kg_planner::Measure(one, rounds);
  }
  return EXIT_SUCCESS;
}
