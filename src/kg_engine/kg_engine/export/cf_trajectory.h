// A plan as NetCDF: CF-1.8 trajectories in a contiguous ragged array (discrete
// sampling geometry, H.4.3), one trajectory per agent.
// https://cfconventions.org/Data/cf-conventions/cf-conventions-1.8/cf-conventions.html

#ifndef KG_ENGINE_EXPORT_CF_TRAJECTORY_H_
#define KG_ENGINE_EXPORT_CF_TRAJECTORY_H_

#include <string>

#include "kg_engine/export/plan_tracks.h"

namespace kg_engine {

// Writes a classic NetCDF file. Throws kg_base::InputError naming the path on
// failure, or if the plan has no track.
void WriteCfTrajectory(const PlanTracks& plan, const std::string& path);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_CF_TRAJECTORY_H_
