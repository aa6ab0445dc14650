#include "kg_engine/command/change.h"

#include <iostream>

#include "kg_base/common/clock.h"
#include "kg_core/facts/update_log.h"
#include "kg_engine/command/command.h"
#include "kg_engine/facts/plan_status.h"
#include "kg_engine/state/mission_state.h"
#include "kg_mission/mission/ingest.h"

namespace kg_engine::command {

std::vector<std::string> Stage(const kg_core::FactUpdate& update,
                               const std::string& data_folder,
                               const Target& target,
                               kg_core::Transaction* transaction) {
  kg_mission::FileCache files(target.mission_folder, data_folder);
  std::vector<std::string> reasons =
      kg_mission::StageUpdateWithFiles(update, files, *transaction)
          .judgement.reasons;
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
