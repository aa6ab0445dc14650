// The check that offers pass in every mode: a path that cannot be part of any
// plan is rejected with the reason, so that the modes need not handle malformed
// input.

#ifndef KG_SELECTOR_TEAM_SCREENING_H_
#define KG_SELECTOR_TEAM_SCREENING_H_

#include <string>
#include <vector>

#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/team_plan.h"

namespace kg_selector {

struct ScreenedOffer {
  std::vector<Pathlet> sound;  // In the order offered; agent, round set.
  std::vector<RejectedPath> rejected;  // Ditto.
};

// Turned away: what FindViolation() finds, and what is malformed (a number that
// is not finite, windows that do not ascend or are not planned, times that
// descend; its reason says "malformed: "). A path offered twice counts once.
ScreenedOffer ScreenOffer(const TeamRules& rules, const std::string& agent,
                          std::vector<Pathlet> offered, int round);

// Why `pathlet` cannot be weighed at all; empty if it can.
std::string Malformed(const TeamRules& rules, const Pathlet& pathlet);

// The same visits, worth the same, along the same track.
bool SamePath(const Pathlet& a, const Pathlet& b);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_SCREENING_H_
