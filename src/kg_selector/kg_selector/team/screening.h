// Screening of offers, common to all modes: a path that cannot be part of any
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
  std::vector<Pathlet> sound;  // In the order offered; agent and round set.
  std::vector<RejectedPath> rejected;  // In the order offered.
};

// Rejects paths for which FindViolation() finds a violation, and malformed ones
// (a number is not finite, windows do not ascend or are not planned, times
// decrease; the reason starts with "malformed: "). Drops duplicates.
ScreenedOffer ScreenOffer(const TeamRules& rules, const std::string& agent,
                          std::vector<Pathlet> offered, int round);

// Why `pathlet` is malformed; empty if it is not.
std::string Malformed(const TeamRules& rules, const Pathlet& pathlet);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_SCREENING_H_
