// Enumerations whose values are given as strings in the facts.

#ifndef KG_MISSION_MISSION_CHOICE_H_
#define KG_MISSION_MISSION_CHOICE_H_

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "kg_base/common/join_strings.h"
#include "kg_mission/mission/entity.h"

namespace kg_mission {

// An enumeration value and its name in the facts.
template <typename Value>
struct NamedChoice {
  const char* name;
  Value value;
};

[[noreturn]] inline void RefuseChoice(const FactEntity& entity,
                                      const kg_core::Term& property,
                                      const std::vector<std::string>& names,
                                      const std::string& name) {
  entity.Refuse(property, "one of " + kg_base::JoinStrings(names) + ", not \"" +
                              name + "\"");
}

// The value named by `property`; `fallback` if absent.
template <typename Table, typename Value>
Value Choice(const FactEntity& entity, const kg_core::Term& property,
             const Table& table, Value fallback) {
  if (!entity.One(property)) return fallback;
  const std::string name = entity.Text(property);
  std::vector<std::string> names;
  for (const auto& row : table) {
    if (name == row.name) return row.value;
    names.push_back(row.name);
  }
  RefuseChoice(entity, property, names, name);
}

// The name stated by `property`, one of `names`; the first if absent.
template <typename Names>
std::string NameChoice(const FactEntity& entity, const kg_core::Term& property,
                       const Names& names) {
  if (!entity.One(property)) return *std::begin(names);
  const std::string name = entity.Text(property);
  if (std::find(std::begin(names), std::end(names), name) == std::end(names)) {
    RefuseChoice(entity, property, {std::begin(names), std::end(names)}, name);
  }
  return name;
}

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_CHOICE_H_
