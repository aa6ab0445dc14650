// Exports: facts in RDF syntaxes, plans in formats for maps, GPS, gliders and
// ocean data. Reads only a snapshot of the store, so it can run while facts
// change, and after a restart.

#ifndef KG_ENGINE_EXPORT_EXPORT_SERVER_H_
#define KG_ENGINE_EXPORT_EXPORT_SERVER_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"

namespace kg_engine {

// Names of the formats, e.g. "turtle", "netcdf".
std::vector<std::string> ExportFormats();

struct ExportRequest {
  std::string format;  // One of ExportFormats().
  // IRIs, or prefixed names; empty = the facts, or the current plan. Plan
  // formats: at most one.
  std::vector<std::string> graphs;
  // File to write ("goto": folder), absolute; empty = answer in `data`.
  std::string path;
};

struct ExportAnswer {
  bool ok = false;
  std::string error;  // One line.
  std::uint64_t world_version = 0;
  std::string data;
};

// Writes the file, if requested, atomically. "goto" writes
// <path>/<agent>/goto_l10.ma, and goto_l11.ma and so on for more stops than a
// list may have, and removes those of an earlier export; none for an agent with
// nothing left to fly, which `data` then names. An error if no agent has.
ExportAnswer Export(const kg_core::GraphView& view,
                    const ExportRequest& request);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_EXPORT_SERVER_H_
