// The layers of one agent's window as they are shown: 0..100, -1 = no data
// (land).
//
//   REWARD, FUSED, FUSED_VIEW  0 = none; 100 = what 99.5 % of the cells of any
//                              value do not exceed, so that a few bright events
//                              do not leave all the rest dark
//   UNCERTAINTY, ATTENUATION   percent
//   POLICY                     50 = none, 100 = the largest weight, whatever
//                              its sign, 0 = the same below zero
//   FEASIBILITY, REACH         100 = yes, 0 = no
//   WORK                       0..98 = share of the time there is; 99 = too far
//                              for it, 100 = forbidden
//
// What they are: docs/equations.md, sections 1 and 2.

#ifndef KG_ENGINE_DISPLAY_LAYERS_H_
#define KG_ENGINE_DISPLAY_LAYERS_H_

#include <cstdint>
#include <vector>

#include "kg_compiler/control_plane/work.h"
#include "kg_compiler/data_plane/mission_tensor.h"

namespace kg_engine {

inline constexpr std::int8_t kNoDataPercent = -1;

using Percents = std::vector<std::int8_t>;  // By cell.

struct ShownLayer {
  const char* name;
  bool of_pose;  // Reads `work`, which is made for it; else it may be null.
  Percents (*paint)(const kg_compiler::MissionTensor& tensor,
                    const kg_compiler::WorkMap* work);
};
const std::vector<ShownLayer>& ShownLayers();

// What FUSED is shown as.
Percents FusedPercents(const kg_compiler::MissionTensor& tensor);

}  // namespace kg_engine

#endif  // KG_ENGINE_DISPLAY_LAYERS_H_
