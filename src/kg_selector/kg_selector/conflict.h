// What two members of one team may not both do.

#ifndef KG_SELECTOR_CONFLICT_H_
#define KG_SELECTOR_CONFLICT_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kg_selector/pathlet.h"

namespace kg_selector {

struct TeamRules {
  // How many distinct agents an event rewards over its life.
  std::map<std::string, int> event_capacity;
  // Agents stay at least this far apart at all times; 0 = only never at the
  // same place in the same window.
  double separation_m = 0.0;
  bool separation_is_hard = true;
  // Soft: reward lost per metre and approach below separation_m.
  double separation_weight_per_m = 0.0;
  std::string mode = "greedy";
  int max_rounds = 8;
};

enum class ConflictKind { kSeparation, kCapacity };
const char* Name(ConflictKind kind);  // "separation", "capacity"

struct Conflict {
  ConflictKind kind = ConflictKind::kSeparation;
  std::string with_agent;  // Who was committed before.
  int window = -1;         // Where it happens.
  std::string event;       // kCapacity: the event that is full.
  double margin = 0.0;     // Metres missing, or visits too many (negative).
  std::string Line() const;  // For a person, one line.
};

// The first (by window) hard conflict of `pathlet` with those committed.
std::optional<Conflict> FindConflict(const TeamRules& rules,
                                     const std::vector<Pathlet>& committed,
                                     const Pathlet& pathlet);

}  // namespace kg_selector

#endif  // KG_SELECTOR_CONFLICT_H_
