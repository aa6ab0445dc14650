// Target of a subcommand: an existing store, or a mission folder read into
// memory.

#ifndef KG_ENGINE_COMMAND_TARGET_H_
#define KG_ENGINE_COMMAND_TARGET_H_

#include <memory>
#include <string>

#include "kg_core/rdf/store.h"

namespace kg_engine::command {

// The folder of mission.ttl and shapes.ttl: next to the installed or built
// program, else in the source tree. Throws InputError listing the places
// searched.
std::string OntologyFolder();

struct Target {
  std::unique_ptr<kg_core::Store> store;
  std::string mission_folder;  // Folder for file lookup; may be empty.
};

// Whether OpenTarget reads `path` as a mission. A folder with a store is a
// store.
bool IsMissionFolder(const std::string& path);

// Throws InputError, also if the store is in use by a running node. If a
// mission's files are missing, ingested facts are omitted, with a warning on
// stderr. `data_folder` is searched first for files.
Target OpenTarget(const std::string& path, const std::string& data_folder);
// Opens a store. OpenOrMakeStore creates it, with the ontology, if `path` does
// not exist and ends in .db.
Target OpenStore(const std::string& path);
Target OpenOrMakeStore(const std::string& path);

}  // namespace kg_engine::command

#endif  // KG_ENGINE_COMMAND_TARGET_H_
