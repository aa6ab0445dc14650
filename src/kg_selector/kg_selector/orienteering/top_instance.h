// Files of the Team Orienteering benchmark of Chao, Golden and Wasil (1996).
//
//   n 32                 points: first = start, last = end
//   m 2                  paths
//   tmax 5.0             maximum length of each path
//   10.5 14.4 0          x, y, score; one line per point
//
// Fields are separated by blanks or tabs, lines end with LF or CRLF, empty
// lines are skipped. Lengths are Euclidean. Scores of start and end are
// ignored.

#ifndef KG_SELECTOR_ORIENTEERING_TOP_INSTANCE_H_
#define KG_SELECTOR_ORIENTEERING_TOP_INSTANCE_H_

#include <map>
#include <string>
#include <vector>

#include "kg_planner/tours/orienteering.h"

namespace kg_selector {

// Tolerance on tmax, so that rounding does not make a tour infeasible.
constexpr double kLengthSlack = 1e-9;

struct TopInstance {
  int paths = 1;
  double limit = 0.0;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> scores;
};

// Throws kg_base::InputError with file, line and the expected content.
TopInstance ReadTopInstance(const std::string& path);

// Reads lines of file name and published value. Keyed by file name; throws as
// ReadTopInstance().
std::map<std::string, double> ReadTopReferences(const std::string& path);

// The orienteering problem, with as many tours as the instance has paths.
kg_planner::OrienteeringProblem ToOrienteering(const TopInstance& instance);

}  // namespace kg_selector

#endif  // KG_SELECTOR_ORIENTEERING_TOP_INSTANCE_H_
