// Changes of facts from the command line: checked, logged, accepted or rejected
// as a whole.

#ifndef KG_ENGINE_COMMAND_CHANGE_H_
#define KG_ENGINE_COMMAND_CHANGE_H_

#include <string>
#include <vector>

#include "kg_engine/command/target.h"
#include "kg_mission/mission/stage_update.h"

namespace kg_engine::command {

// Is there an ex:Mission among the facts? A store may hold others.
bool HoldsMission(const kg_core::GraphView& view);

// Stages `update` as a running node would: with pending ingest of files and its
// log entry. Marks an existing plan stale. Returns the reasons for rejection.
std::vector<std::string> Stage(const kg_core::FactUpdate& update,
                               const std::string& data_folder,
                               const Target& target,
                               kg_core::Transaction* transaction);

// Commits, or prints the reasons, one per line; returns the exit status.
int Finish(const std::vector<std::string>& reasons,
           kg_core::Transaction* transaction);

}  // namespace kg_engine::command

#endif  // KG_ENGINE_COMMAND_CHANGE_H_
