// What one tensor is compiled from.

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
  std::vector<std::string> derived_from;  // What every window's blend read.
};

// The first four must be there; all must outlive what is made with them.
struct TensorInputs {
  const kg_mission::Mission* mission = nullptr;
  const kg_mission::Agent* agent = nullptr;
  const kg_mission::TimeWindow* window = nullptr;
  const WindowRasters* rasters = nullptr;
  // If and only if the policy's confidence mode is kHorizon.
  const HorizonScale* horizon = nullptr;
  // Where tensors that are compiled one after the other, or at the same time,
  // find what they have in common. It goes by the rasters' hashes, so they
  // must be those of what is there.
  DataPlaneCache* cache = nullptr;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_TENSOR_INPUTS_H_
