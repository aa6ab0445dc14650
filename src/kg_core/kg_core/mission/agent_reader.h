// The agents of a mission: policy, capabilities, start, and what rules or an
// operator forbid each of them.

#ifndef KG_CORE_MISSION_AGENT_READER_H_
#define KG_CORE_MISSION_AGENT_READER_H_

#include <vector>

#include "kg_core/mission/calendar.h"
#include "kg_core/mission/entity.h"
#include "kg_core/mission/mission.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_core {

// By id. `asserted` is the graph as it is, `view` with its conclusions. Throws
// InputError.
std::vector<Agent> ReadAgents(const GraphView& asserted, const GraphView& view,
                              const WindowCalendar& calendar,
                              const FactEntity& mission);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_AGENT_READER_H_
