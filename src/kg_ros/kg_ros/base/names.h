// Every topic and service name of the interface, in one place. Relative: they
// stand in the namespace the node is started in.

#ifndef KG_ROS_BASE_NAMES_H_
#define KG_ROS_BASE_NAMES_H_

#include <string>

namespace kg_ros {

inline constexpr char kFactsTopic[] = "kg/facts";
inline constexpr char kUpdatesTopic[] = "kg/updates";
inline constexpr char kWorldTopic[] = "kg/world";
inline constexpr char kAgentStatesTopic[] = "kg/agent_states";
inline constexpr char kWorkFieldsTopic[] = "kg/work_fields";
inline constexpr char kCoordinationTopic[] = "kg/coordination";
inline constexpr char kNavGraphsTopic[] = "kg/nav_graphs";
inline constexpr char kCandidatesTopic[] = "kg/candidates";
inline constexpr char kAssignmentsTopic[] = "kg/assignments";
inline constexpr char kRoundRequestsTopic[] = "kg/round_requests";
inline constexpr char kRejectionsTopic[] = "kg/rejections";
inline constexpr char kWatchedTopic[] = "kg/watched";
inline constexpr char kMarkersTopic[] = "kg/markers";
inline constexpr char kClickedPointTopic[] = "clicked_point";  // rviz.

inline constexpr char kUpdateService[] = "kg/update";
inline constexpr char kQueryService[] = "kg/query";
inline constexpr char kWatchService[] = "kg/watch";
inline constexpr char kWhyService[] = "kg/why";
inline constexpr char kWhatIfService[] = "kg/what_if";
inline constexpr char kValidateService[] = "kg/validate";
inline constexpr char kCheckService[] = "kg/check";
inline constexpr char kExportService[] = "kg/export";

inline std::string AgentTopic(const std::string& agent_id,
                              const std::string& name) {
  return "kg/" + agent_id + "/" + name;
}
inline constexpr char kTensors[] = "tensors";
inline constexpr char kSeamRules[] = "seam_rules";
inline constexpr char kHeatmap[] = "heatmap";
inline constexpr char kPath[] = "path";
inline constexpr char kWork[] = "work";
inline constexpr char kWorkClicked[] = "work_clicked";
inline std::string LayerName(const std::string& layer) {
  return "layer/" + layer;
}

inline constexpr char kMapFrame[] = "map";
inline constexpr char kEarthFrame[] = "earth";
inline std::string BaseFrame(const std::string& agent_id) {
  return agent_id + "/base_link";
}

inline constexpr bool kLatched = true;
// Queue length of topics with a message a window: more than a mission has.
inline constexpr unsigned kAllWindows = 512;

}  // namespace kg_ros

#endif  // KG_ROS_BASE_NAMES_H_
