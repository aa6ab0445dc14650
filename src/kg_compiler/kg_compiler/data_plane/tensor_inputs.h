// Inputs of compiling one tensor.

#ifndef KG_COMPILER_DATA_PLANE_TENSOR_INPUTS_H_
#define KG_COMPILER_DATA_PLANE_TENSOR_INPUTS_H_

#include <string>
#include <vector>

#include "kg_compiler/data_plane/data_plane_cache.h"
#include "kg_compiler/data_plane/window_rasters.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// One N for all windows of an agent (A1, `horizon`).
struct HorizonScale {
  double low = 0.0;
  double range = 0.0;
  std::vector<std::string> derived_from;  // Inputs of all windows' blends.
};

// The first four are required; all must outlive objects made with them.
struct TensorInputs {
  const kg_mission::Mission* mission = nullptr;
  const kg_mission::Agent* agent = nullptr;
  const kg_mission::TimeWindow* window = nullptr;
  const WindowRasters* rasters = nullptr;
  // Set if and only if the policy's confidence mode is kHorizon.
  const HorizonScale* horizon = nullptr;
  // Cache of common data for tensors compiled in sequence or concurrently. It
  // is keyed by the rasters' hashes, which must therefore be valid.
  DataPlaneCache* cache = nullptr;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_TENSOR_INPUTS_H_
