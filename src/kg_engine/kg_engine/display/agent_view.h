// The operator's view: one agent in one window of one compilation, and the
// positions from which it can depart.

#ifndef KG_ENGINE_DISPLAY_AGENT_VIEW_H_
#define KG_ENGINE_DISPLAY_AGENT_VIEW_H_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/work.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_selector/team/committed_plan.h"

namespace kg_engine {

struct Scene {
  std::shared_ptr<const kg_compiler::Compilation> compilation;
  int window = 0;
  std::map<std::string, AgentPose> poses;  // By ex:id.
  double time_s = 0.0;                     // Mission time [Unix s].
  kg_selector::CommittedPlan plan;         // Last committed plan.
};

// View of an agent in a window. Shares ownership of its inputs.
class AgentView {
 public:
  // Nullopt if the agent has no tensor, currents or rules for the window.
  static std::optional<AgentView> Of(const Scene& scene,
                                     const std::string& agent_id);

  const kg_compiler::MissionTensor& tensor() const { return *tensor_; }
  // Departure positions of the agent in this window: its current position in
  // the first planned window; later the plan's waypoint of the previous window,
  // or the current position if there is none.
  const std::vector<kg_base::LonLat>& places() const { return places_; }

  kg_compiler::WorkMap WorkFrom(
      const std::vector<kg_base::LonLat>& places) const;
  // Cache key: equal keys give equal results of WorkFrom for these places.
  std::string WorkKey(const std::vector<kg_base::LonLat>& places) const;

 private:
  AgentView() = default;

  std::shared_ptr<const kg_compiler::MissionTensor> tensor_;
  std::shared_ptr<const kg_compiler::WorkField> field_;
  kg_compiler::SeamRules rules_;
  kg_compiler::WindowRules window_;
  std::vector<kg_base::LonLat> places_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_DISPLAY_AGENT_VIEW_H_
