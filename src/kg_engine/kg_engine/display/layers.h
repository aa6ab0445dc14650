// The layers of one agent's window as displayed: 0..100, -1 = no data (land).
//
//   REWARD, FUSED, FUSED_VIEW  0 = none; 100 = the 99.5 % quantile of the cells
//   with
//                              nonzero value, so that a few bright events do
//                              not darken the rest
//   UNCERTAINTY, ATTENUATION   percent
//   POLICY                     50 = none, 100 = the largest absolute weight,
//                              0 = its negative
//   FEASIBILITY, REACH         100 = yes, 0 = no
//   WORK                       0..98 = share of the available time; 99 = too
//   far,
//                              100 = forbidden
//
// Definitions: docs/equations.md, sections 1 and 2.

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
  bool of_pose;  // Needs `work`; otherwise `work` may be null.
  Percents (*paint)(const kg_compiler::MissionTensor& tensor,
                    const kg_compiler::WorkMap* work);
};
const std::vector<ShownLayer>& ShownLayers();

// Display values of FUSED.
Percents FusedPercents(const kg_compiler::MissionTensor& tensor);

}  // namespace kg_engine

#endif  // KG_ENGINE_DISPLAY_LAYERS_H_
