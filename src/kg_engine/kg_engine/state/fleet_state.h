// Positions of the agents and mission time: the inputs that arrive as
// observations, not as facts from an operator. Mission time is that of the
// newest observation; it never decreases.

#ifndef KG_ENGINE_STATE_FLEET_STATE_H_
#define KG_ENGINE_STATE_FLEET_STATE_H_

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_mission/mission/mission.h"

namespace kg_engine {

struct AgentPose {
  kg_base::LonLat position;
  double heading_rad = 0.0;  // Clockwise from north.
  double time_s = 0.0;       // Mission time [Unix s].
  double energy_left_j = std::numeric_limits<double>::quiet_NaN();
  bool observed = false;  // True: reported by the agent; false: from facts.
};

class FleetState {
 public:
  // Places agents at the positions in the facts, at the begin of the first
  // window.
  void Reset(const kg_mission::Mission& mission);
  // Restores the poses of a stored fleet.
  void Restore(const std::map<std::string, AgentPose>& poses, double time_s);

  // Late observations are accepted but never replace a newer one. False if the
  // agent is unknown or a number is not finite (energy may be NaN).
  bool Observe(const std::string& agent_id, const AgentPose& pose);
  // Adds and removes agents according to the facts; agents that have reported
  // keep their pose, others are placed as in the facts.
  void Follow(const kg_mission::Mission& mission);
  // The agent whose report defines mission time; empty before any report.
  std::string Clock() const;

  const std::map<std::string, AgentPose>& poses() const { return poses_; }
  double time_s() const { return time_s_; }
  // Whether all agents have reported at time_s().
  bool IsComplete() const;
  // Window that contains `time_s()`; the number of windows after the last.
  int CurrentWindow(const kg_mission::Mission& mission) const;

 private:
  std::map<std::string, AgentPose> poses_;  // By ex:id.
  double time_s_ = 0.0;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_FLEET_STATE_H_
