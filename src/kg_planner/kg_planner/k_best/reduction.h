// Reduces a trellis without losing allowed paths; node numbers stay.

#ifndef KG_PLANNER_K_BEST_REDUCTION_H_
#define KG_PLANNER_K_BEST_REDUCTION_H_

#include <vector>

#include "kg_planner/k_best/search_trellis.h"

namespace kg_planner {

// Removes dead-end seams and seams that no path within a limit can use (one
// limit at a time). `limits` by resource; infinity = no limit.
void DropUnaffordable(const std::vector<double>& limits, SearchTrellis* search);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_REDUCTION_H_
