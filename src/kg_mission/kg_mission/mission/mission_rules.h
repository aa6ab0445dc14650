// Rules over mission facts: what they may not conclude, because it is read
// before the rules run.

#ifndef KG_MISSION_MISSION_MISSION_RULES_H_
#define KG_MISSION_MISSION_MISSION_RULES_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_mission {

// The reason why no rule may conclude this property or class of the mission's
// ontology; nothing if rules may.
std::optional<std::string> FindForbiddenConclusion(const kg_core::Term& term);

// StageInferences (rules/inference.h) with the above. Returns the reasons to
// reject the transaction.
std::vector<std::string> StageMissionRules(kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_MISSION_RULES_H_
