// Reads the typed mission out of the facts and what the rules conclude from
// them, which counts as much (facts_and_conclusions.h). All is valid by then
// (validator.h); what only becomes visible here (an agent without a start, two
// windows of one index, a prior weight for a layer that does not exist) is
// refused with one line that names subject, property and expectation.

#ifndef KG_MISSION_MISSION_MISSION_READER_H_
#define KG_MISSION_MISSION_MISSION_READER_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// Throws InputError.
Mission ReadMission(const kg_core::GraphView& view);

// Times between windows that no window covers, a line each: allowed, but
// nothing is planned there.
std::vector<std::string> WindowGaps(const Mission& mission);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_MISSION_READER_H_
