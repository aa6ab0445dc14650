#include "kg_selector/team/team_plan.h"

namespace kg_selector {

PlanRequest RequestAround(const TeamRules& rules,
                          const std::vector<Pathlet>& committed) {
  return {committed, FullEvents(rules, committed), {}, {}};
}

}  // namespace kg_selector
