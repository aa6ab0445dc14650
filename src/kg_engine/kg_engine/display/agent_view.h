// What an operator looks at: one agent in one window of one compilation, and
// where the agent can come from.

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
  double time_s = 0.0;                     // Mission time, Unix seconds.
  kg_selector::CommittedPlan plan;         // The last one committed.
};

// The way of an agent through a window. Keeps what it was made of.
class AgentView {
 public:
  // Nothing if the agent has no tensor, currents or rules of the window.
  static std::optional<AgentView> Of(const Scene& scene,
                                     const std::string& agent_id);

  const kg_compiler::MissionTensor& tensor() const { return *tensor_; }
  // Where the agent departs from in this window: where it is, in the first
  // window that is planned; after that the plan's waypoint of the window
  // before, or where it is if there is none.
  const std::vector<kg_base::LonLat>& places() const { return places_; }

  kg_compiler::WorkMap WorkFrom(
      const std::vector<kg_base::LonLat>& places) const;
  // Equal if WorkFrom gives the same from the same places.
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
