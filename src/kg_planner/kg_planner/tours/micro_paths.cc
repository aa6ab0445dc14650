#include "kg_planner/tours/micro_paths.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "kg_planner/tours/micro_graph.h"
#include "kg_planner/tours/micro_labels.h"
#include "kg_planner/tours/micro_search.h"

namespace kg_planner {
namespace {

void Check(const MicroPathOptions& options) {
  if (options.per_end < 1) throw std::invalid_argument("per_end: below 1");
  if (options.max_nodes < 1) throw std::invalid_argument("max_nodes: below 1");
  if (!(options.good_enough >= 0.0 && options.good_enough <= 1.0)) {
    throw std::invalid_argument("good_enough: not in [0, 1]");
  }
  if (std::isnan(options.deadline_s)) {
    throw std::invalid_argument("deadline_s: not a number");
  }
}

bool ByEndThenScore(const MicroPath& a, const MicroPath& b) {
  if (a.nodes.back() != b.nodes.back()) return a.nodes.back() < b.nodes.back();
  if (a.score() != b.score()) return a.score() > b.score();
  return BetterOrder(a, b);
}

std::vector<MicroPath> Select(std::vector<MicroPath> paths,
                              const MicroPathOptions& options) {
  std::sort(paths.begin(), paths.end(), ByEndThenScore);
  std::vector<MicroPath> kept;
  int taken = 0;           // Paths kept with this end.
  double min_value = 0.0;  // Minimum score for this end.
  for (MicroPath& path : paths) {
    const bool first =
        kept.empty() || kept.back().nodes.back() != path.nodes.back();
    if (first) {
      taken = 0;
      min_value =
          path.score() - (1.0 - options.good_enough) * std::abs(path.score());
    }
    const bool good = taken < options.per_end && path.score() >= min_value;
    if (good) ++taken;
    if (good || path.nodes.size() == 1) kept.push_back(std::move(path));
  }
  return kept;
}

using Clock = std::chrono::steady_clock;

// A deadline of about a year or more counts as none.
Clock::time_point ToDeadline(const MicroPathOptions& options) {
  if (!(options.deadline_s < 3.0e7)) return Clock::time_point::max();
  const std::chrono::duration<double> left(std::max(0.0, options.deadline_s));
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(left);
}

// Chosen so that the beam makes about as many labels as allowed; kept small,
// since the following search uses the time better.
std::size_t BeamWidth(const StageProblem& problem,
                      const MicroPathOptions& options) {
  const std::size_t labels = problem.legs.size() * options.max_nodes;
  return std::clamp<std::size_t>(options.exact_labels / (labels + 1), 1, 8);
}

}  // namespace

MicroPaths FindMicroPaths(const StageProblem& problem,
                          const MicroPathOptions& options) {
  Check(options);
  const MicroGraph graph(problem);
  LabelOptions labels;
  labels.max_nodes = options.max_nodes;
  labels.max_labels = options.exact_labels;
  labels.deadline = ToDeadline(options);
  LabelSearch search = SearchLabels(graph, labels);
  const bool proven = search.complete;
  if (!proven) {
    labels.max_labels = std::numeric_limits<std::size_t>::max();
    labels.beam = BeamWidth(problem, options);
    search = SearchLabels(graph, labels);
    search.paths = ImproveMicroPaths(graph, std::move(search.paths), options,
                                     labels.deadline);
  }
  return {Select(std::move(search.paths), options), proven};
}

}  // namespace kg_planner
