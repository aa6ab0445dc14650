#include "kg_selector/team/coordinator.h"

#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_selector/team/column_team.h"
#include "kg_selector/team/greedy_team.h"

namespace kg_selector {

Ask AskAround(const TeamRules& rules, const std::vector<Pathlet>& committed) {
  return {committed, FullEvents(rules, committed), {}, {}};
}

std::unique_ptr<Coordinator> MakeCoordinator(const TeamRules& rules,
                                             std::vector<std::string> agents) {
  if (rules.mode == "greedy")
    return std::make_unique<GreedyTeam>(rules, std::move(agents));
  if (auto search = MakeSearch(rules))
    return std::make_unique<ColumnTeam>(rules, agents, std::move(search));
  throw kg_core::InputError(
      "team mode '" + rules.mode +
      "': expected 'greedy', 'auction', 'priced' or 'exact'");
}

}  // namespace kg_selector
