#include "kg_selector/team/team_modes.h"

#include "kg_base/common/input_error.h"
#include "kg_mission/mission/option_names.h"
#include "kg_selector/team/auction_search.h"
#include "kg_selector/team/column_team.h"
#include "kg_selector/team/exact_search.h"
#include "kg_selector/team/greedy_team.h"
#include "kg_selector/team/priced_search.h"

namespace kg_selector {
namespace {

std::unique_ptr<Coordinator> MakeGreedyTeam(
    const TeamRules& rules, const std::vector<std::string>& agents) {
  return std::make_unique<GreedyTeam>(rules, agents);
}

// A mode with columns: only its search differs.
template <typename Search>
std::unique_ptr<Coordinator> MakeColumnTeam(
    const TeamRules& rules, const std::vector<std::string>& agents) {
  const SearchOptions options{rules.max_rounds, rules.gap_goal,
                              rules.auction_epsilon, rules.time_limit_s};
  return std::make_unique<ColumnTeam>(rules, agents,
                                      std::make_unique<Search>(options));
}

}  // namespace

const std::vector<TeamMode>& TeamModes() {
  static const std::vector<TeamMode> modes = {
      {kg_mission::kGreedyMode, MakeGreedyTeam, PlanToursGreedily},
      {kg_mission::kAuctionMode, MakeColumnTeam<AuctionSearch>,
       PlanToursByAuction},
      {kg_mission::kPricedMode, MakeColumnTeam<PricedSearch>,
       PlanToursByPrices},
      {kg_mission::kExactMode, MakeColumnTeam<ExactSearch>, PlanToursExactly}};
  return modes;
}

const TeamMode* FindTeamMode(const std::string& name) {
  for (const TeamMode& mode : TeamModes()) {
    if (mode.name == name) return &mode;
  }
  return nullptr;
}

std::vector<std::string> TeamModeNames() {
  std::vector<std::string> names;
  for (const TeamMode& mode : TeamModes()) names.emplace_back(mode.name);
  return names;
}

std::string TeamModeChoices(const std::string& quote) {
  const std::vector<TeamMode>& modes = TeamModes();
  std::string text;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (i > 0) text += i + 1 == modes.size() ? " or " : ", ";
    text += quote + modes[i].name + quote;
  }
  return text;
}

std::unique_ptr<Coordinator> MakeCoordinator(
    const TeamRules& rules, const std::vector<std::string>& agents) {
  const TeamMode* mode = FindTeamMode(rules.mode);
  if (mode == nullptr) {
    throw kg_base::InputError("team mode '" + rules.mode + "': expected " +
                              TeamModeChoices("'"));
  }
  return mode->make_coordinator(rules, agents);
}

}  // namespace kg_selector
