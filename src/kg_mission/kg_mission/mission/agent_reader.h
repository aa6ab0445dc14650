// Reads the agents of a mission: policy, capabilities, start, and the areas
// forbidden to each by rules or by an operator.

#ifndef KG_MISSION_MISSION_AGENT_READER_H_
#define KG_MISSION_MISSION_AGENT_READER_H_

#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/calendar.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// The agents sorted by id. `asserted` is the graph of asserted facts, `view`
// the same graph with conclusions. Throws InputError.
std::vector<Agent> ReadAgents(const kg_core::GraphView& asserted,
                              const kg_core::GraphView& view,
                              const WindowCalendar& calendar,
                              const FactEntity& mission);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_AGENT_READER_H_
