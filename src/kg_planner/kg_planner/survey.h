// One look at every number of a trellis: is it sound, in which order do its
// seams stand, and how large can a path's total get.

#ifndef KG_PLANNER_SURVEY_H_
#define KG_PLANNER_SURVEY_H_

#include <cstddef>

#include "kg_planner/trellis.h"

namespace kg_planner {

struct Survey {
  bool sorted = true;  // Every stage's seams ascend by (from, to).
  bool has_tokens = false;
  double largest_total = 0.0;  // No part of a path's score is larger.
};

// Nodes that seams into `stage` come from: one before the first stage.
int NodesBefore(const Trellis& trellis, std::size_t stage);

// Throws as Check() does.
Survey CheckAndSurvey(const Trellis& trellis);

}  // namespace kg_planner

#endif  // KG_PLANNER_SURVEY_H_
