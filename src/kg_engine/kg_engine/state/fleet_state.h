// Where the agents are and how far the mission has come: what arrives by itself
// rather than by an operator's hand. Mission time is that of the newest
// observation; it never goes back.

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
  double time_s = 0.0;       // Unix seconds, mission time.
  double energy_left_j = std::numeric_limits<double>::quiet_NaN();
  bool observed = false;  // Reported by the agent; else what the facts say.
};

class FleetState {
 public:
  // Agents start where the facts say, when the first window begins.
  void Reset(const kg_mission::Mission& mission);
  // Takes over where a stored fleet was.
  void Restore(const std::map<std::string, AgentPose>& poses, double time_s);

  // Late observations are accepted but never replace a newer one. False if the
  // agent is unknown or a number is not finite (energy may be NaN).
  bool Observe(const std::string& agent_id, const AgentPose& pose);
  // Agents that have come or gone by a fact; those that have reported keep
  // their pose, others are where the facts say.
  void Follow(const kg_mission::Mission& mission);
  // The agent whose report mission time is; empty before anybody's.
  std::string Clock() const;

  const std::map<std::string, AgentPose>& poses() const { return poses_; }
  double time_s() const { return time_s_; }
  // Has everybody been seen at time_s()?
  bool IsComplete() const;
  // The window that `time_s()` lies in; the number of windows after the last.
  int CurrentWindow(const kg_mission::Mission& mission) const;

 private:
  std::map<std::string, AgentPose> poses_;  // By ex:id.
  double time_s_ = 0.0;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_FLEET_STATE_H_
