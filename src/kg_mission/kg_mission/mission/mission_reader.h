// Reads the typed mission from the facts and the conclusions of the rules,
// which count as facts (facts_and_conclusions.h). The input has been validated
// (validator.h); errors that only show up here (an agent without a start, two
// windows with the same index, a prior weight for a layer that does not exist)
// are reported in one line that names subject, property and expectation.

#ifndef KG_MISSION_MISSION_MISSION_READER_H_
#define KG_MISSION_MISSION_MISSION_READER_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// Throws InputError.
Mission ReadMission(const kg_core::GraphView& view);

// Time gaps between windows, one line each. Gaps are allowed, but nothing is
// planned in them.
std::vector<std::string> WindowGaps(const Mission& mission);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_MISSION_READER_H_
