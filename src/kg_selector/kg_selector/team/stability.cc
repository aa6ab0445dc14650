#include "kg_selector/team/stability.h"

#include <map>
#include <string>
#include <utility>

#include "kg_base/geo/geodesy.h"
#include "kg_selector/paths/conflict.h"

namespace kg_selector {

PlanStability ComputeStability(const std::vector<Pathlet>& before,
                               const std::vector<Pathlet>& now) {
  std::map<std::pair<std::string, int>, kg_base::LonLat> places;
  for (const Pathlet& pathlet : before) {
    for (const Visit& visit : pathlet.visits) {
      places[{pathlet.agent, visit.window}] = visit.position;
    }
  }
  // Count only windows that both plans have.
  int common = 0, same = 0;
  double sum_m = 0.0;
  for (const Pathlet& pathlet : now) {
    for (const Visit& visit : pathlet.visits) {
      const auto place = places.find({pathlet.agent, visit.window});
      if (place == places.end()) continue;
      const double moved_m = kg_base::Distance_m(place->second, visit.position);
      ++common;
      if (moved_m <= kSamePlace_m) ++same;
      sum_m += moved_m;
    }
  }
  if (common == 0) return {};
  return {static_cast<double>(same) / common, sum_m / common};
}

}  // namespace kg_selector
