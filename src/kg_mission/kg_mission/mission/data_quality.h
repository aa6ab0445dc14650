// What was read of each variable of the mission's files, and how good it is:
// ex:DataQualityReport. The ingest states it as facts; `kg validate`, the
// reports on updates and the diagnostics of the node show these facts.

#ifndef KG_MISSION_MISSION_DATA_QUALITY_H_
#define KG_MISSION_MISSION_DATA_QUALITY_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_mission {

// States the report of one variable about `subject` in the facts graph.
// `mission_begin_s`: begin of the first window [Unix s].
void StateDataQuality(const kg_core::Term& subject,
                      const kg_base::FieldFile& file,
                      const kg_base::QuantitySeries& series,
                      double mission_begin_s,
                      kg_core::Transaction& transaction);

// What was read of one variable, for users.
struct DataSummary {
  std::string what;  // "ex:currents: eastward velocity"
  std::string text;  // "water_u of /data/ocean.nc; 17 times, ...": one line.
};
// Summaries of all reports in a store, sorted by their nodes.
std::vector<DataSummary> SummarizeData(const kg_core::GraphView& view);

// The warnings of all reports, one line each: node whose ingest read the file,
// variables, warning. Variables with the same warning share a line.
std::vector<std::string> DataWarnings(const kg_core::GraphView& view);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_DATA_QUALITY_H_
