// Sentinels: the value of a nonexistent path, and the limit of an unlimited
// resource.

#ifndef KG_PLANNER_K_BEST_NO_VALUE_H_
#define KG_PLANNER_K_BEST_NO_VALUE_H_

#include <limits>

namespace kg_planner {

inline constexpr double kNone = -std::numeric_limits<double>::infinity();
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_NO_VALUE_H_
