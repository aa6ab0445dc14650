// Files of the Team Orienteering benchmark of Chao, Golden and Wasil (1996).
//
//   n 32                 points, the first the start, the last the end
//   m 2                  paths
//   tmax 5.0             length of each at most
//   10.5 14.4 0          x, y, score; a line a point
//
// Fields are parted by blanks or tabs, lines end with LF or CRLF, empty lines
// are passed over. Lengths are Euclidean. Scores of start and end count
// nothing.

#ifndef KG_SELECTOR_ORIENTEERING_TOP_INSTANCE_H_
#define KG_SELECTOR_ORIENTEERING_TOP_INSTANCE_H_

#include <map>
#include <string>
#include <vector>

#include "kg_planner/tours/orienteering.h"

namespace kg_selector {

// Lengths may exceed tmax by this, so that rounding decides nothing.
constexpr double kLengthSlack = 1e-9;

struct TopInstance {
  int paths = 1;
  double limit = 0.0;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> scores;
};

// Throws kg_base::InputError with file and line, and what was expected.
TopInstance ReadTopInstance(const std::string& path);

// Lines of a file name and the published value. By name; throws likewise.
std::map<std::string, double> ReadTopReferences(const std::string& path);

// As many tours as paths.
kg_planner::OrienteeringProblem ToOrienteering(const TopInstance& instance);

}  // namespace kg_selector

#endif  // KG_SELECTOR_ORIENTEERING_TOP_INSTANCE_H_
