#include "kg_compiler/control_plane/work.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_compiler/control_plane/window_traversal.h"

namespace kg_compiler {
namespace {

constexpr float kNotReached = std::numeric_limits<float>::quiet_NaN();

CellAccess AccessOf(float feasibility) {
  if (std::isnan(feasibility)) return CellAccess::kNoData;
  return feasibility == 1.0f ? CellAccess::kTooFar : CellAccess::kForbidden;
}

}  // namespace

std::optional<double> WorkMap::Share(std::size_t cell) const {
  if (access[cell] != CellAccess::kReached) return std::nullopt;
  return std::clamp(time_s[cell] / budget_s, 0.0, 1.0);
}

WorkMap ComputeWork(const SeamRules& rules, const WindowRules& window,
                    const WindowWorld& world,
                    const std::vector<kg_base::LonLat>& places) {
  WorkMap work;
  work.budget_s = std::min(window.end_s - window.begin_s,
                           window.base_travel_m / rules.motion.cruise_mps);
  for (const float feasibility : world.tensor->Get(Layer::kFeasibility)) {
    work.access.push_back(AccessOf(feasibility));
  }
  work.time_s.assign(work.access.size(), kNotReached);
  if (!(work.budget_s > 0.0)) return work;
  const WindowTraversal traversal(rules, window, world);
  for (const kg_base::LonLat& place : places) {
    for (const ReachedCell& cell : traversal.ReachFrom(place).cells) {
      float& time_s = work.time_s[cell.index];
      const float arrival_s = static_cast<float>(cell.arrival_s);
      // NaN (not reached before) compares false. Closed cells keep their state.
      if (time_s <= arrival_s ||
          work.access[cell.index] < CellAccess::kTooFar) {
        continue;
      }
      time_s = arrival_s;
      work.access[cell.index] = CellAccess::kReached;
    }
  }
  return work;
}

kg_base::Raster FusedView(const MissionTensor& tensor, const WorkMap& work) {
  kg_base::Raster view = tensor.Get(Layer::kFused);
  for (std::size_t i = 0; i < view.size(); ++i) {
    const std::optional<double> share = work.Share(i);
    view[i] = share ? static_cast<float>(view[i] * (1.0 - *share)) : 0.0f;
  }
  return view;
}

}  // namespace kg_compiler
