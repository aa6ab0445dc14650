// Moves agents along their assigned tracks in mission time, and tracks their
// energy: a stand-in for vehicles that follow their plan.
//
// Mission time runs while the plan is up to date (or planning has failed: then
// the last one is followed) and stands still during planning, so that planning
// takes no mission time at any playback rate. It stops at every window's end
// until the world has entered the next. A plan that begins shortly before the
// current time (it was made while agents moved) is followed from its begin.

#ifndef KG_ENGINE_SIMULATION_AGENT_SIMULATOR_H_
#define KG_ENGINE_SIMULATION_AGENT_SIMULATOR_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_selector/team/committed_plan.h"

namespace kg_engine {

// Inputs of the simulator.
struct SimulatedWorld {
  double time_s = 0.0;  // Mission time, Unix seconds.
  // True if the plan is up to date, or planning has failed and the last plan
  // stays.
  bool plan_holds = false;
  std::uint64_t plan_run = 0;
  std::size_t current_window = 0;    // Number of windows = mission has ended.
  std::vector<double> window_end_s;  // By index.
  std::vector<std::string> agents;   // ex:id.
};

// State reported by a vehicle.
struct SimulatedState {
  std::string agent;    // ex:id.
  double time_s = 0.0;  // Unix seconds.
  kg_base::LonLat position;
  double heading_rad = 0.0;  // Clockwise from north.
  double speed_mps = 0.0;    // Over ground.
  double energy_left_j = std::numeric_limits<double>::quiet_NaN();
};

class AgentSimulator {
 public:
  // `rate`: mission seconds per real second.
  explicit AgentSimulator(double rate) : rate_(rate) {}

  void Take(const SimulatedWorld& world);
  void Take(const kg_selector::CommittedPlan& plan);
  // Sets an agent's remaining energy at the begin of its track.
  void TakeEnergy(const std::string& agent, double energy_j);

  // Ids of the world's agents.
  const std::vector<std::string>& agents() const { return world_.agents; }

  // Advances by `real_s` seconds of real time; returns all states. Empty
  // without a plan, or if the mission has ended.
  std::vector<SimulatedState> Advance(double real_s);

 private:
  struct Agent {
    std::vector<kg_compiler::TimedPoint> track;
    std::vector<kg_selector::Visit> visits;
    double energy_j = 0.0;  // Remaining at the track's begin.
    bool has_energy = false;
  };

  SimulatedState StateOf(const std::string& id, const Agent& agent) const;
  double EnergyUsed_j(const Agent& agent) const;
  bool MayGoOn() const;
  double Limit_s() const;

  double rate_;
  double time_s_ = 0.0;  // Mission time, Unix seconds.
  SimulatedWorld world_;
  std::uint64_t plan_run_ = 0;  // Run of the followed tracks.
  std::map<std::string, Agent> agents_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SIMULATION_AGENT_SIMULATOR_H_
