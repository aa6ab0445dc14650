// Scope of a fact: the windows or agents that it names; none named = all of
// them.

#ifndef KG_MISSION_MISSION_SCOPE_H_
#define KG_MISSION_MISSION_SCOPE_H_

#include <algorithm>
#include <vector>

namespace kg_mission {

template <typename Value>
bool InScope(const std::vector<Value>& scope, const Value& value) {
  return scope.empty() ||
         std::find(scope.begin(), scope.end(), value) != scope.end();
}

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_SCOPE_H_
