// For tests: closest approach of two tracks, sampled in time with geodesics.
// Shares no code with the closed form (pathlet.h).

#ifndef KG_SELECTOR_TESTING_SAMPLED_DISTANCE_H_
#define KG_SELECTOR_TESTING_SAMPLED_DISTANCE_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kg_base/geo/geodesy.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

inline kg_base::LonLat PlaceAt(
    const std::vector<kg_compiler::TimedPoint>& track, double time_s) {
  std::size_t i = 1;
  while (i + 1 < track.size() && track[i].time_s < time_s) ++i;
  const auto& p = track[i - 1];
  const auto& q = track[i];
  const double share =
      q.time_s > p.time_s ? (time_s - p.time_s) / (q.time_s - p.time_s) : 1.0;
  return {
      p.position.lon_deg + share * (q.position.lon_deg - p.position.lon_deg),
      p.position.lat_deg + share * (q.position.lat_deg - p.position.lat_deg)};
}

struct SampleTimes {
  double from_s = 0.0;  // Sampled from here to the end of a's track [s].
  double step_s = 60.0;
};

inline double LeastDistance_m(const Pathlet& a, const Pathlet& b,
                              const SampleTimes& sampling) {
  double least_m = 1e12;
  const double end_s = a.track.back().time_s;
  for (double t_s = sampling.from_s; t_s <= end_s; t_s += sampling.step_s) {
    least_m = std::min(least_m, kg_base::Distance_m(PlaceAt(a.track, t_s),
                                                    PlaceAt(b.track, t_s)));
  }
  return least_m;
}

}  // namespace kg_selector

#endif  // KG_SELECTOR_TESTING_SAMPLED_DISTANCE_H_
