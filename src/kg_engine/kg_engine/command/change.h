// Changes of facts from the command line: checked, logged, refused whole.

#ifndef KG_ENGINE_COMMAND_CHANGE_H_
#define KG_ENGINE_COMMAND_CHANGE_H_

#include <string>
#include <vector>

#include "kg_engine/command/target.h"
#include "kg_mission/mission/stage_update.h"

namespace kg_engine::command {

// Stages `update` as a running node would: with what its files say, if they are
// due, and its log entry. A plan that was there is marked stale. Returns the
// reasons to refuse it.
std::vector<std::string> Stage(const kg_core::FactUpdate& update,
                               const std::string& data_folder,
                               const Target& target,
                               kg_core::Transaction* transaction);

// Commits, or shows the reasons, a line each; what is to be returned.
int Finish(const std::vector<std::string>& reasons,
           kg_core::Transaction* transaction);

}  // namespace kg_engine::command

#endif  // KG_ENGINE_COMMAND_CHANGE_H_
