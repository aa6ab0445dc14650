// Rules over mission facts, and the conclusions they may not draw because those
// terms are read before the rules run.

#ifndef KG_MISSION_MISSION_MISSION_RULES_H_
#define KG_MISSION_MISSION_MISSION_RULES_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_mission {

// The reason why no rule may conclude this property or class of the mission's
// ontology; nullopt if rules may.
std::optional<std::string> FindForbiddenConclusion(const kg_core::Term& term);

// StageInferences (rules/inference.h) with the forbidden terms above. Returns
// the reasons to reject the transaction.
std::vector<std::string> StageMissionRules(kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_MISSION_RULES_H_
