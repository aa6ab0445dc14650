// Facts against the vocabulary, before the shapes: what SHACL's open world
// would let pass. An unknown property, a subject without a class, a speed
// stated of an agent instead of its capabilities, a text where a number
// belongs.

#ifndef KG_MISSION_MISSION_STATEMENT_CHECK_H_
#define KG_MISSION_MISSION_STATEMENT_CHECK_H_

#include <set>
#include <string>
#include <vector>

#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Reasons to refuse what stands about the subjects that `transaction` changes.
std::vector<std::string> CheckChangedSubjects(
    const kg_core::Vocabulary& vocabulary,
    const kg_core::Transaction& transaction);

// Likewise what `view` says about `subjects`.
std::vector<std::string> CheckSubjects(const kg_core::Vocabulary& vocabulary,
                                       const kg_core::GraphView& view,
                                       const std::set<kg_core::Term>& subjects);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_STATEMENT_CHECK_H_
