// One agent's planning: holds the newest rules and rasters, and plans once they
// are consistent. Computes the agent's waypoints and seams with the control
// plane, and its paths with the planner.

#ifndef KG_ENGINE_PLANNING_AGENT_PLANNER_H_
#define KG_ENGINE_PLANNING_AGENT_PLANNER_H_

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
#include "kg_engine/planning/agent_graph.h"
#include "kg_planner/k_best/k_best_memory.h"
#include "kg_selector/paths/walks.h"
#include "kg_selector/team/agent_candidates.h"
#include "kg_selector/team/round_request.h"

namespace kg_engine {

// Result of planning.
struct PlannerAnswer {
  std::vector<AgentGraph> graphs;  // By window; empty in rounds > 0.
  kg_selector::AgentCandidates candidates;
};

class AgentPlanner {
 public:
  using TensorPointer = std::shared_ptr<const kg_compiler::MissionTensor>;
  using FieldPointer = std::shared_ptr<const kg_compiler::WorkField>;

  // Rules of an older cycle than the newest are ignored.
  void Take(const kg_compiler::SeamRules& rules, std::uint64_t cycle);
  void Take(TensorPointer tensor);
  void Take(FieldPointer field);
  // Requests of the run that has ended are not answered any more.
  void Take(const kg_selector::RunEnd& end) { last_end_ = end; }
  // Is the raster of this window and hash here already?
  bool HasTensor(int window, const std::string& hash) const;
  bool HasField(int window, const std::string& hash) const;

  // True if new rules have arrived and are not planned yet.
  bool IsDue() const { return due_; }
  // True if every raster named by the rules has arrived.
  bool IsComplete() const;
  // The window whose raster is missing, for the log; empty if complete.
  std::string Missing() const;

  // Plans round 0. Requires IsComplete(). A mission that cannot be planned
  // (no waypoint within reach) is an answer without pathlets and with a note.
  PlannerAnswer Plan();

  // Plans under what `request` asks of this agent: around those committed, at
  // its prices. Nothing if it does not ask, is of another cycle, or of a run
  // that has ended. Throws kg_base::InputError for prices that make no sense.
  std::optional<PlannerAnswer> PlanAgain(
      const kg_selector::RoundRequest& request);

  std::uint64_t cycle() const { return cycle_; }

 private:
  std::vector<kg_compiler::WindowWorld> Worlds() const;
  kg_selector::AgentCandidates Stitch(const kg_selector::AskedOf& asked,
                                      std::uint32_t round) const;
  std::vector<AgentGraph> Graphs(
      const kg_selector::AgentCandidates& candidates) const;
  kg_selector::AgentCandidates Header(std::uint32_t round) const;

  kg_compiler::SeamRules rules_;
  std::uint64_t cycle_ = 0;
  bool due_ = false;
  std::optional<kg_selector::RunEnd> last_end_;
  std::map<int, TensorPointer> tensors_;  // By window.
  std::map<int, FieldPointer> fields_;
  kg_compiler::NavGraphs graphs_;  // Graphs of the last plan.
  kg_selector::GraphCache cache_;  // Reused by the next plan.
  std::string trouble_;            // Reason if there are no graphs.
  std::shared_ptr<kg_planner::KBestMemory> memory_ =
      std::make_shared<kg_planner::KBestMemory>();
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PLANNING_AGENT_PLANNER_H_
