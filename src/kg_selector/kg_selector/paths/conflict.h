// What two members of one team may not both do.
//
// Capacity: an event rewards so many distinct agents over its life. A visit
// counts if it earns the event's reward (Visit::events); being at a full
// event's place for other reasons is allowed, and earns nothing there
// (CloseEvents in masking.h).
//
// Separation: agents stay separation_m apart at all times, in the plane (depth
// is ignored), on tracks that include holding station until a window ends. In
// any case, and where separation is soft or 0, they never come closer than
// kSamePlace_m: station is held until a window ends, so this keeps two visits
// of one window from the same place.
// Agents that begin closer together (launched from one ship) must be apart by
// the end of the first window, and from when they are.
//
// Energy and expiry: what one path may not do, whatever the others do.

#ifndef KG_SELECTOR_PATHS_CONFLICT_H_
#define KG_SELECTOR_PATHS_CONFLICT_H_

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

struct TeamRules {
  // How many distinct agents an event rewards over its life.
  std::map<std::string, int> event_capacity;
  // Agents stay at least this far apart at all times; 0 = only never at the
  // same place in the same window.
  double separation_m = 0.0;
  bool separation_is_hard = true;
  // Soft: reward lost per metre that the closest approach to each committed
  // agent lies below separation_m.
  double separation_weight_per_m = 0.0;
  std::string mode = "greedy";  // A name of the table in team_modes.h.
  int max_rounds = 8;           // Of planning, the first included.
  // Modes with prices stop when the plan is this close to its bound (a share).
  double gap_goal = 0.01;
  double auction_epsilon = 0.05;      // Least raise of a price [reward].
  double time_limit_s = 2.0;          // Of choosing among the candidates.
  std::string fairness = "scarcity";  // "scarcity", "balance", "max_min".
  double fairness_weight =
      0.0;  // Weight of the spread of loads in "balance" [reward].
  // What an agent may use up; absent = not limited. By its name in the team.
  std::map<std::string, double> energy_budget_j;
  // Windows in which an event rewards; absent = any.
  std::map<std::string, std::set<int>> event_windows;
  // By window index [Unix s]. If absent, a conflict's window is unknown (-1),
  // and agents may not begin too close together.
  std::map<int, double> window_end_s;
};

constexpr double kSamePlace_m = 1.0;

// What no two tracks may come closer than [m].
double HardSeparation_m(const TeamRules& rules);

enum class ConflictKind {
  kSeparation,
  kCapacity,
  kEnergy,
  kExpired,
  kOutbid,
  kMalformed
};
// "separation", "capacity", "energy", "expired", "outbid", "malformed"
const char* Name(ConflictKind kind);
// The inverse; nothing for another name.
std::optional<ConflictKind> ParseConflictKind(const std::string& name);

struct Conflict {
  ConflictKind kind = ConflictKind::kSeparation;
  std::string with_agent;  // Who was committed before.
  int window = -1;         // Where it happens.
  std::string event;       // kCapacity: the event that is full; kExpired.
  // Metres missing, visits too many (negative), joules above the budget,
  // windows too late, or reward by which others were worth more.
  double margin = 0.0;
  std::string Line() const;  // For a person, one line.
};

// When the separation rule begins to hold for two tracks that may begin too
// close together; -infinity = from the start. `first_window` is a's.
double SeparationBegins_s(const TeamRules& rules, int first_window,
                          const std::vector<kg_compiler::TimedPoint>& a,
                          const std::vector<kg_compiler::TimedPoint>& b);

// Events whose capacity the committed paths use up.
std::set<std::string> FullEvents(const TeamRules& rules,
                                 const std::vector<Pathlet>& committed);

// Reward that soft separation takes off `pathlet`; 0 if separation is hard.
double SoftPenalty(const TeamRules& rules,
                   const std::vector<Pathlet>& committed,
                   const Pathlet& pathlet);

// What rules `pathlet` out whatever is asked of its planner: its energy, then
// an event outside of its windows.
std::optional<Conflict> FindViolation(const TeamRules& rules,
                                      const Pathlet& pathlet);

// The first (by window) hard conflict of `pathlet` with those committed; in
// one window separation before capacity, and the worst first.
std::optional<Conflict> FindConflict(const TeamRules& rules,
                                     const std::vector<Pathlet>& committed,
                                     const Pathlet& pathlet);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_CONFLICT_H_
