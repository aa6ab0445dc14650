// One agent's planning, without ROS topics: holds the newest rules and rasters,
// and plans when they belong together. Finds the agent's waypoints and seams
// with the control plane, and its paths with the planner.

#ifndef KG_ROS_PLANNING_PLANNER_SERVER_H_
#define KG_ROS_PLANNING_PLANNER_SERVER_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_msgs/Candidates.h"
#include "kg_msgs/MissionTensor.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Rejections.h"
#include "kg_msgs/SeamRules.h"
#include "kg_msgs/WorkField.h"
#include "kg_planner/k_best/k_best_memory.h"
#include "kg_ros/conversion/ask_conversion.h"
#include "kg_selector/paths/walks.h"

namespace kg_ros {

// What a plan gives out.
struct PlannerAnswer {
  std::vector<kg_msgs::NavGraph> nav_graphs;  // Empty in rounds > 0.
  kg_msgs::Candidates candidates;
};

class PlannerServer {
 public:
  // All throw kg_core::InputError for a message that makes no sense.
  void Take(const kg_msgs::SeamRules& message);
  void Take(const kg_msgs::MissionTensor& message);
  void Take(const kg_msgs::WorkField& message);

  // New rules are here and not planned yet.
  bool IsDue() const { return due_; }
  // Every raster the rules name is here.
  bool IsComplete() const;
  // The window whose raster is missing, for the log; empty if complete.
  std::string Missing() const;

  // Plans round 0. Requires IsComplete(). A mission that cannot be planned
  // (no waypoint within reach) is an answer without pathlets and with a note.
  PlannerAnswer Plan();

  // Plans under what `message` asks of this agent: around those committed, at
  // its prices. Nothing if it does not ask, or is of another cycle. Throws
  // kg_core::InputError for prices that make no sense.
  std::optional<PlannerAnswer> PlanAgain(const kg_msgs::Rejections& message);

  std::uint64_t cycle() const { return cycle_; }

 private:
  std::vector<kg_compiler::WindowWorld> Worlds() const;
  kg_msgs::Candidates Stitch(const AskedOf& asked, std::uint32_t round) const;
  void MarkStaging(const kg_msgs::Candidates& candidates,
                   std::vector<kg_msgs::NavGraph>* graphs) const;
  kg_msgs::Candidates Header(std::uint32_t round) const;

  kg_compiler::SeamRules rules_;
  std::uint64_t cycle_ = 0;
  bool due_ = false;
  std::map<int, std::shared_ptr<const kg_compiler::MissionTensor>> tensors_;
  std::map<int, std::shared_ptr<const kg_compiler::WorkField>> fields_;
  kg_compiler::NavGraphs graphs_;  // Of the last plan.
  kg_selector::GraphCache cache_;  // For the next one.
  std::string trouble_;            // Why there are none.
  std::shared_ptr<kg_planner::KBestMemory> memory_ =
      std::make_shared<kg_planner::KBestMemory>();
};

}  // namespace kg_ros

#endif  // KG_ROS_PLANNING_PLANNER_SERVER_H_
