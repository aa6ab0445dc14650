// Exports: facts in the syntaxes of RDF, plans in the formats of maps, GPS,
// gliders and ocean data. Reads a snapshot of the store and nothing else, so it
// may run while facts change, and after a restart.

#ifndef KG_ENGINE_EXPORT_EXPORT_SERVER_H_
#define KG_ENGINE_EXPORT_EXPORT_SERVER_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"

namespace kg_engine {

// The names of the formats, e.g. "turtle", "netcdf".
std::vector<std::string> ExportFormats();

struct ExportRequest {
  std::string format;  // One of ExportFormats().
  // IRIs, or with our prefixes; empty: the facts, or the current plan. Of a
  // plan one at most.
  std::vector<std::string> graphs;
  // File to write (of "goto": folder), absolute; empty: the answer has `data`.
  std::string path;
};

struct ExportAnswer {
  bool ok = false;
  std::string error;  // One line.
  std::uint64_t world_version = 0;
  std::string data;
};

// Writes the file, if one is asked for, whole or not at all. "goto" writes
// <path>/<agent>/goto_l10.ma for every agent.
ExportAnswer Export(const kg_core::GraphView& view,
                    const ExportRequest& request);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_EXPORT_SERVER_H_
