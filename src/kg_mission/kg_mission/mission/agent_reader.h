// The agents of a mission: policy, capabilities, start, and what rules or an
// operator forbid each of them.

#ifndef KG_MISSION_MISSION_AGENT_READER_H_
#define KG_MISSION_MISSION_AGENT_READER_H_

#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/calendar.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// By id. `asserted` is the graph as it is, `view` with its conclusions. Throws
// InputError.
std::vector<Agent> ReadAgents(const kg_core::GraphView& asserted,
                              const kg_core::GraphView& view,
                              const WindowCalendar& calendar,
                              const FactEntity& mission);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_AGENT_READER_H_
