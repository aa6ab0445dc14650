#include "kg_engine/simulation/track_position.h"

#include <algorithm>

namespace kg_engine {

using kg_compiler::TimedPoint;

kg_base::LonLat PositionAt(const std::vector<TimedPoint>& track,
                           const double time_s) {
  const auto after = std::lower_bound(
      track.begin(), track.end(), time_s,
      [](const TimedPoint& point, double t) { return point.time_s < t; });
  if (after == track.begin()) return track.front().position;
  if (after == track.end()) return track.back().position;
  const TimedPoint& a = *(after - 1);
  const TimedPoint& b = *after;
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  return {
      a.position.lon_deg + share * (b.position.lon_deg - a.position.lon_deg),
      a.position.lat_deg + share * (b.position.lat_deg - a.position.lat_deg)};
}

}  // namespace kg_engine
