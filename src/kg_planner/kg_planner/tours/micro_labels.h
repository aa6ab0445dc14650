// Label setting over (set of visited nodes, end), level by level in the number
// of nodes.

#ifndef KG_PLANNER_TOURS_MICRO_LABELS_H_
#define KG_PLANNER_TOURS_MICRO_LABELS_H_

#include <chrono>
#include <cstddef>
#include <vector>

#include "kg_planner/tours/micro_graph.h"
#include "kg_planner/tours/micro_problem.h"

namespace kg_planner {

struct LabelOptions {
  int max_nodes = 8;
  // Maximum number of labels; the search stops beyond.
  std::size_t max_labels = 20000;
  // Beam width: labels kept per end and number of nodes, best first; 0 = all.
  std::size_t beam = 0;
  // The search stops at this time.
  std::chrono::steady_clock::time_point deadline =
      std::chrono::steady_clock::time_point::max();
};

struct LabelSearch {
  std::vector<MicroPath> paths;  // Best order for each (set, end) found.
  bool complete = true;          // Neither stopped early nor cut by the beam.
};

LabelSearch SearchLabels(const MicroGraph& graph, const LabelOptions& options);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_LABELS_H_
