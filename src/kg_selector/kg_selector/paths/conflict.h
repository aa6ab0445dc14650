// Hard rules between the paths of one team, and limits of a single path.
//
// Capacity: an event rewards at most event_capacity distinct agents over its
// life. A visit counts if it earns the event's reward (Visit::events); passing
// the place of a full event is allowed and earns nothing (CloseEvents in
// masking.h).
//
// Separation: agents stay separation_m apart at all times, in the plane (depth
// is ignored), on tracks that include holding station until a window ends. Even
// if separation is soft or 0, they never come closer than kSamePlace_m: because
// station is held until a window ends, no two agents visit the same place in
// one window. Agents that start closer together (launched from one ship) are
// exempt until they are apart, at the latest until the end of the first window.
//
// Energy and expiry: limits of a single path, independent of the others.

#ifndef KG_SELECTOR_PATHS_CONFLICT_H_
#define KG_SELECTOR_PATHS_CONFLICT_H_

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kg_mission/mission/option_names.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

struct TeamRules {
  // Maximum number of distinct agents an event rewards over its life, by IRI.
  std::map<std::string, int> event_capacity;
  // Minimum distance between agents at all times [m]; 0 = only kSamePlace_m
  // applies.
  double separation_m = 0.0;
  bool separation_is_hard = true;
  // Soft separation: reward lost per metre by which the closest approach to
  // each committed agent falls below separation_m.
  double separation_weight_per_m = 0.0;
  std::string mode = kg_mission::kGreedyMode;  // See team_modes.h.
  int max_rounds = 8;  // Planning rounds, the first included.
  // Modes with prices stop at this relative gap between plan and bound.
  double gap_goal = 0.01;
  double auction_epsilon = 0.05;  // Minimum price increment [reward].
  double time_limit_s = 2.0;      // Limit of the choice among candidates [s].
  std::string fairness = kg_mission::kScarcityFairness;
  double fairness_weight =
      0.0;  // Weight of the spread of loads in "balance" [reward].
  // Energy budget by agent name in the team [J]; absent = unlimited.
  std::map<std::string, double> energy_budget_j;
  // Windows in which an event rewards; absent = any.
  std::map<std::string, std::set<int>> event_windows;
  // End of each window, by index [Unix s]. If absent, a conflict's window is
  // unknown (-1), and agents may not start too close together.
  std::map<int, double> window_end_s;
};

constexpr double kSamePlace_m = 1.0;

// Hard minimum distance between any two tracks [m].
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
// Inverse of Name(); nullopt for an unknown name.
std::optional<ConflictKind> ParseConflictKind(const std::string& name);

struct Conflict {
  ConflictKind kind = ConflictKind::kSeparation;
  std::string with_agent;  // The agent committed earlier.
  int window = -1;         // Window of the conflict; -1 = unknown.
  std::string event;       // kCapacity: the full event; kExpired: the event.
  // Missing distance [m], excess visits (negative), energy above the budget
  // [J], windows too late, or the reward by which others were better.
  double margin = 0.0;
  std::string Line() const;  // Display text, one line.
};

// Time from which the separation rule applies to two tracks that may start too
// close together [Unix s]; -infinity = from the start. `first_window` is that
// of `a`.
double SeparationBegins_s(const TeamRules& rules, int first_window,
                          const std::vector<kg_compiler::TimedPoint>& a,
                          const std::vector<kg_compiler::TimedPoint>& b);

// Events whose capacity is used up by the committed paths.
std::set<std::string> FullEvents(const TeamRules& rules,
                                 const std::vector<Pathlet>& committed);

// Penalty of soft separation for `pathlet` [reward]; 0 if separation is hard.
double SoftPenalty(const TeamRules& rules,
                   const std::vector<Pathlet>& committed,
                   const Pathlet& pathlet);

// The first violation that excludes `pathlet` regardless of the request: its
// energy, then an event outside its windows.
std::optional<Conflict> FindViolation(const TeamRules& rules,
                                      const Pathlet& pathlet);

// The first hard conflict (by window) of `pathlet` with the committed paths;
// within one window separation before capacity, and the largest margin first.
std::optional<Conflict> FindConflict(const TeamRules& rules,
                                     const std::vector<Pathlet>& committed,
                                     const Pathlet& pathlet);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_CONFLICT_H_
