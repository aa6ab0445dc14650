// Paths and markers for rviz in the frame "map". All numbers sent are finite:
// rviz aborts on others.

#ifndef KG_ROS_DISPLAY_DISPLAY_H_
#define KG_ROS_DISPLAY_DISPLAY_H_

#include <map>
#include <string>
#include <vector>

#include "kg_base/geo/map_projection.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/explain/fact_warnings.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_mission/mission/mission.h"
#include "kg_selector/team/agent_candidates.h"
#include "kg_selector/team/committed_plan.h"
#include "nav_msgs/Path.h"
#include "visualization_msgs/MarkerArray.h"

namespace kg_ros {

nav_msgs::Path ToPath(const kg_selector::Pathlet& pathlet,
                      const kg_base::MapProjection& map);

// Distance from the grid's western to its eastern edge [m].
double WidthOf(const kg_base::Grid& grid, const kg_base::MapProjection& map);

// Namespaces: "constraints", "land", "events", "currents", "agents",
// "nav_graph/<id>", "candidates/<id>", "staging/<id>", "assigned/<id>",
// "warnings".
class MarkerPainter {
 public:
  // Reference map width for sizes of lines and points; they shrink with smaller
  // maps.
  static constexpr double kMapWidth_m = 2e6;

  explicit MarkerPainter(kg_base::MapProjection map,
                         double width_m = kMapWidth_m);

  // Areas that apply in a window, and the events that are active in it.
  void PaintConstraints(const kg_mission::Mission& mission, int window);
  void PaintEvents(const kg_mission::Mission& mission, int window);
  // The coast: cells without data adjacent to cells with data. Empty if all
  // have data.
  void PaintLand(const kg_base::VectorField& field);
  // Arrows on a thinned grid, at the window's middle.
  void PaintField(const kg_compiler::WorkField& field, double time_s);
  void PaintNavGraph(const kg_engine::AgentGraph& graph);
  // Staging edges of the graph, in purple, for any window.
  void PaintStaging(const kg_engine::AgentGraph& graph);
  void PaintCandidates(const kg_selector::AgentCandidates& candidates);
  // Track of the assignment, and its intermediate stops.
  void PaintAssignment(const kg_selector::PathAssignment& assignment);

  // An arrow and a name per agent, sized for a view of the whole `grid`.
  void PaintAgents(const std::map<std::string, kg_engine::AgentPose>& poses,
                   const kg_base::Grid& grid);

  // A text for each fact without effect, where it lies; of one off the grid at
  // the nearest place of the grid, without a place at its middle.
  void PaintWarnings(const std::vector<kg_compiler::FactWarning>& warnings,
                     const kg_base::Grid& grid);

  // All markers, preceded by one that deletes the previous ones.
  visualization_msgs::MarkerArray Take();

 private:
  void PaintTrack(const std::vector<kg_compiler::TimedPoint>& track, double z_m,
                  visualization_msgs::Marker* marker) const;
  visualization_msgs::Marker& Add(const std::string& name, int type);

  kg_base::MapProjection map_;
  double size_;
  visualization_msgs::MarkerArray markers_;
};

}  // namespace kg_ros

#endif  // KG_ROS_DISPLAY_DISPLAY_H_
