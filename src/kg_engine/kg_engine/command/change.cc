#include "kg_engine/command/change.h"

#include <iostream>

#include "kg_base/common/clock.h"
#include "kg_base/common/input_error.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/update_log.h"
#include "kg_engine/command/command.h"
#include "kg_engine/facts/plan_status.h"
#include "kg_engine/state/mission_state.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission_reader.h"

namespace kg_engine::command {

bool HoldsMission(const kg_core::GraphView& view) {
  return !kg_core::FindInstances(view, kg_core::kFactsGraph,
                                 kg_core::Ex("Mission"))
              .empty();
}

namespace {

// Why the facts are not a mission that a node could read; empty if they are, or
// if the store holds other facts than a mission's, before and after.
std::vector<std::string> CheckMission(const kg_core::GraphView& before,
                                      const kg_core::GraphView& after) {
  if (!HoldsMission(before) && !HoldsMission(after)) return {};
  try {
    kg_mission::ReadMission(after);
  } catch (const kg_base::InputError& error) {
    return {error.what()};
  }
  return {};
}

}  // namespace

std::vector<std::string> Stage(const kg_core::FactUpdate& update,
                               const std::string& data_folder,
                               const Target& target,
                               kg_core::Transaction* transaction) {
  kg_mission::FileCache files(target.mission_folder, data_folder);
  std::vector<std::string> reasons =
      kg_mission::StageUpdateWithFiles(update, files, *transaction)
          .judgement.reasons;
  if (reasons.empty()) {
    reasons = CheckMission(*target.store->Read(), transaction->view());
  }
  if (reasons.empty() && !transaction->empty()) {
    kg_core::LogUpdate(update, kg_base::Now_s(), *transaction);
    const std::uint64_t run = LoadState(transaction->view()).plan_run;
    if (run > 0) StagePlanStatus(run, "stale", transaction);
  }
  return reasons;
}

int Finish(const std::vector<std::string>& reasons,
           kg_core::Transaction* transaction) {
  for (const std::string& reason : reasons) {
    std::cerr << "refused: " << reason << "\n";
  }
  if (!reasons.empty()) return kRefused;
  if (transaction->empty()) {
    std::cout << "nothing to change\n";
    return kDone;
  }
  const std::uint64_t version = transaction->Commit(kg_core::WorldChange::kYes);
  std::cout << "world version " << version << "\n";
  return kDone;
}

}  // namespace kg_engine::command
