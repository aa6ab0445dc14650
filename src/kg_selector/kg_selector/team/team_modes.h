// The table of team modes. A row has the name (as in ex:teamMode, the message
// CoordinationRules and the option --mode) and the factory of its coordinator.
// To add a mode: its name in option_names.h of kg_mission, a file for it, and a
// row in team_modes.cc.

#ifndef KG_SELECTOR_TEAM_TEAM_MODES_H_
#define KG_SELECTOR_TEAM_TEAM_MODES_H_

#include <memory>
#include <string>
#include <vector>

#include "kg_selector/orienteering/team_orienteering.h"
#include "kg_selector/paths/conflict.h"
#include "kg_selector/team/coordinator.h"

namespace kg_selector {

struct TeamMode {
  const char* name;
  // Makes the coordinator of a team under these rules.
  std::unique_ptr<Coordinator> (*make_coordinator)(
      const TeamRules& rules, const std::vector<std::string>& agents);
  // The corresponding method for tours of the Team Orienteering benchmark.
  TourPlanner plan_tours;
};

// Every mode, in the order of kg_mission::kTeamModeNames.
const std::vector<TeamMode>& TeamModes();

// Null = unknown mode.
const TeamMode* FindTeamMode(const std::string& name);

std::vector<std::string> TeamModeNames();

// "greedy, auction, priced or exact", each name in `quote`: for error messages.
std::string TeamModeChoices(const std::string& quote = "");

// Makes the coordinator of rules.mode. Throws kg_base::InputError for an
// unknown mode and, in modes with columns, for an unknown fairness.
std::unique_ptr<Coordinator> MakeCoordinator(
    const TeamRules& rules, const std::vector<std::string>& agents);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_MODES_H_
