// Expiry of facts: removes facts whose end of validity lies before mission
// time.
//
// ex:validUntil (of constraints, prior layers and events) and ex:expires (of
// coolings) give the end of validity. In the mission reader such an entity
// applies in windows that begin before it; the update made here removes its
// facts once mission time has reached it, in a regular transaction: checked,
// logged with old values, versioned. ex:expiresAfter of an event ends only its
// rewards (A42): the event is kept, because agents may have visited it.

#ifndef KG_MISSION_MISSION_EXPIRY_H_
#define KG_MISSION_MISSION_EXPIRY_H_

#include <string>
#include <vector>

#include "kg_core/facts/fact_update.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_mission {

// Time of the next expiry in `view` after `after_s`, Unix seconds; infinity if
// none.
double NextExpiry_s(const kg_core::GraphView& view, double after_s);

struct ExpiredFacts {
  kg_core::FactUpdate update;  // Author "kg"; removes expired facts.
  std::vector<std::string>
      kept;  // One line per subject that cannot be removed, with the reason.
};

// The facts expired by `mission_time_s` (Unix seconds). Subjects to which other
// facts refer are kept, unless those facts expire too.
ExpiredFacts FindExpired(const kg_core::GraphView& view, double mission_time_s);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_EXPIRY_H_
