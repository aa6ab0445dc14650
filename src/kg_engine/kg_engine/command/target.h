// What a subcommand works on: a store that is there, or a mission folder that
// is read into memory.

#ifndef KG_ENGINE_COMMAND_TARGET_H_
#define KG_ENGINE_COMMAND_TARGET_H_

#include <memory>
#include <string>

#include "kg_core/rdf/store.h"

namespace kg_engine::command {

// The folder of mission.ttl and shapes.ttl: beside the installed or built
// program, else where it was built from. Throws InputError that lists where it
// looked.
std::string OntologyFolder();

struct Target {
  std::unique_ptr<kg_core::Store> store;
  std::string mission_folder;  // Where files are looked up; may be empty.
};

// Does OpenTarget read `path` as a mission? A folder with a store is a store.
bool IsMissionFolder(const std::string& path);

// Throws InputError, also if the store is in use by a running node. Where a
// mission's files are not there, what ingest would state is left out, and a
// line on stderr says so. `data_folder`: where files are looked up first.
Target OpenTarget(const std::string& path, const std::string& data_folder);
// Only a store; made, with the ontology in it, if `path` is not there and ends
// in .db.
Target OpenStore(const std::string& path);
Target OpenOrMakeStore(const std::string& path);

}  // namespace kg_engine::command

#endif  // KG_ENGINE_COMMAND_TARGET_H_
