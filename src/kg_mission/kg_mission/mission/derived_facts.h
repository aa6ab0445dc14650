// Facts derived from alternative forms in which operators write facts, updated
// within the same transaction:
//  - the JSON of ex:priors and ex:softOverrides as typed nodes (A30):
//      ex:fast ex:priors "{\"corridor\": 0.8}"
//        => ex:fast ex:hasPriorWeight <fast/prior/corridor> .
//           <fast/prior/corridor> a ex:PriorWeight ;
//               ex:layer ex:corridor ; ex:beta 0.8e0 .
//  - geo:asWKT of a feature as a separate geometry node, and back (A25):
//      ex:zone geo:asWKT W => ex:zone geo:hasGeometry <zone/geometry> .
//           <zone/geometry> a geo:Geometry ; geo:asWKT W .
//  - the times of a window in OWL-Time form, and back (time_forms.h).

#ifndef KG_MISSION_MISSION_DERIVED_FACTS_H_
#define KG_MISSION_MISSION_DERIVED_FACTS_H_

#include <string>
#include <vector>

#include "kg_core/facts/changed_subjects.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Updates the derived facts for the changes of `transaction`. Returns the
// reasons if that fails: malformed JSON or unknown names.
std::vector<std::string> StageDerivedFacts(
    kg_core::Transaction& transaction,
    kg_core::ChangeScope scope = kg_core::ChangeScope::kChanged);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_DERIVED_FACTS_H_
