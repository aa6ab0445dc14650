// Position of an agent on its track at a time.

#ifndef KG_ENGINE_SIMULATION_TRACK_POSITION_H_
#define KG_ENGINE_SIMULATION_TRACK_POSITION_H_

#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_engine {

// Clamped to the first and last point; linear in longitude and latitude in
// between. The track must not be empty.
kg_base::LonLat PositionAt(const std::vector<kg_compiler::TimedPoint>& track,
                           double time_s);

}  // namespace kg_engine

#endif  // KG_ENGINE_SIMULATION_TRACK_POSITION_H_
