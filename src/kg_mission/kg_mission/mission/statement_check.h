// Checks of facts against the vocabulary, before the shapes, for errors that
// SHACL's open world accepts: an unknown property, a subject without a class, a
// speed given for an agent instead of its capabilities, a text instead of a
// number.

#ifndef KG_MISSION_MISSION_STATEMENT_CHECK_H_
#define KG_MISSION_MISSION_STATEMENT_CHECK_H_

#include <set>
#include <string>
#include <vector>

#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Reasons to reject the facts about subjects changed by `transaction`.
std::vector<std::string> CheckChangedSubjects(
    const kg_core::Vocabulary& vocabulary,
    const kg_core::Transaction& transaction);

// Likewise for the facts about `subjects` in `view`.
std::vector<std::string> CheckSubjects(const kg_core::Vocabulary& vocabulary,
                                       const kg_core::GraphView& view,
                                       const std::set<kg_core::Term>& subjects);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_STATEMENT_CHECK_H_
