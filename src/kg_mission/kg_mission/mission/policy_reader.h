// Reads the policy and the capabilities of an agent, in SI units.

#ifndef KG_MISSION_MISSION_POLICY_READER_H_
#define KG_MISSION_MISSION_POLICY_READER_H_

#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// Both throw InputError.
Policy ReadPolicy(const kg_core::GraphView& view, const FactEntity& entity);
Capabilities ReadCapabilities(const FactEntity& entity);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_POLICY_READER_H_
