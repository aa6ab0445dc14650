// Answers kg/export: facts in the syntaxes of RDF, plans in the formats of
// maps, GPS, gliders and ocean data. Reads a snapshot of the store and nothing
// else, so it may run while facts change, and after a restart.

#ifndef KG_ROS_EXPORT_EXPORT_SERVER_H_
#define KG_ROS_EXPORT_EXPORT_SERVER_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_msgs/Export.h"

namespace kg_ros {

// The names of the formats, e.g. "turtle", "netcdf".
std::vector<std::string> ExportFormats();

class ExportServer {
 public:
  // Writes the file, if one is asked for, whole or not at all. An `error` is
  // one line. Graphs may be given as IRIs or with our prefixes; of a plan one,
  // none is the current plan's. "goto" takes a folder as path and writes
  // <path>/<agent>/goto_l10.ma for every agent.
  static kg_msgs::Export::Response Answer(
      const kg_core::GraphView& view, const kg_msgs::Export::Request& request);
};

}  // namespace kg_ros

#endif  // KG_ROS_EXPORT_EXPORT_SERVER_H_
