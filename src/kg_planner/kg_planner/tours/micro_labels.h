// Label setting over (set of nodes visited, end), a number of nodes at a time.

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
  std::size_t max_labels = 20000;  // Made; beyond them the search gives up.
  // Labels kept per end and number of nodes, best first; 0 = all of them.
  std::size_t beam = 0;
  std::chrono::steady_clock::time_point deadline =
      std::chrono::steady_clock::time_point::max();  // Then it gives up, too.
};

struct LabelSearch {
  std::vector<MicroPath> paths;  // The best order of each set and end met.
  bool complete = true;          // Neither given up nor cut by the beam.
};

LabelSearch SearchLabels(const MicroGraph& graph, const LabelOptions& options);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_LABELS_H_
