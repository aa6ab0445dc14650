#include "kg_core/mission/mission.h"

#include <algorithm>

namespace kg_core {
namespace {

template <typename Value>
bool IsEmptyOrHas(const std::vector<Value>& values, const Value& wanted) {
  return values.empty() ||
         std::find(values.begin(), values.end(), wanted) != values.end();
}

}  // namespace

bool Constraint::AppliesTo(const std::string& agent_iri, int window) const {
  return IsEmptyOrHas(windows, window) && IsEmptyOrHas(agents, agent_iri);
}

const Agent* Mission::FindAgent(const std::string& iri) const {
  const auto found =
      std::find_if(agents.begin(), agents.end(),
                   [&](const Agent& agent) { return agent.iri == iri; });
  return found == agents.end() ? nullptr : &*found;
}

}  // namespace kg_core
