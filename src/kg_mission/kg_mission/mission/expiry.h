// Expiry of facts: those that mission time has passed are removed.
//
// ex:validUntil (of constraints, prior layers and events) and ex:expires (of
// coolings) say when. The mission reader lets such a thing apply in windows
// that begin before; the update made here removes the facts about it once
// mission time has reached it, in a transaction like any other: checked,
// logged with old values, numbered. ex:expiresAfter of an event ends its
// rewards only (A42): the event stays, for agents may have visited it.

#ifndef KG_MISSION_MISSION_EXPIRY_H_
#define KG_MISSION_MISSION_EXPIRY_H_

#include <string>
#include <vector>

#include "kg_core/facts/fact_update.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_mission {

// When the next fact in `view` expires after `after_s`; infinity if none.
double NextExpiry_s(const kg_core::GraphView& view, double after_s);

struct ExpiredFacts {
  kg_core::FactUpdate update;  // Author "kg"; removes what is over.
  std::vector<std::string>
      kept;  // What cannot go, a line each with the reason.
};

// What has expired by `mission_time_s`. What other facts still refer to is
// kept, unless they expire, too.
ExpiredFacts FindExpired(const kg_core::GraphView& view, double mission_time_s);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_EXPIRY_H_
