// Enumerations whose values facts name by strings.

#ifndef KG_CORE_MISSION_CHOICE_H_
#define KG_CORE_MISSION_CHOICE_H_

#include <string>
#include <vector>

#include "kg_core/base/join_strings.h"
#include "kg_core/mission/entity.h"

namespace kg_core {

// One value of an enumeration and its name in the facts.
template <typename Value>
struct NamedChoice {
  const char* name;
  Value value;
};
// The value that `property` names; `fallback` if it is absent.
template <typename Table, typename Value>
Value Choice(const FactEntity& entity, const Term& property, const Table& table,
             Value fallback) {
  if (!entity.One(property)) return fallback;
  const std::string name = entity.Text(property);
  std::vector<std::string> names;
  for (const auto& row : table) {
    if (name == row.name) return row.value;
    names.push_back(row.name);
  }
  entity.Refuse(property,
                "one of " + JoinStrings(names) + ", not \"" + name + "\"");
}

}  // namespace kg_core

#endif  // KG_CORE_MISSION_CHOICE_H_
