// The parts of an agent: its policy and its capabilities, in SI.

#ifndef KG_CORE_MISSION_POLICY_READER_H_
#define KG_CORE_MISSION_POLICY_READER_H_

#include "kg_core/mission/entity.h"
#include "kg_core/mission/mission.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_core {

// Both throw InputError.
Policy ReadPolicy(const GraphView& view, const FactEntity& entity);
Capabilities ReadCapabilities(const FactEntity& entity);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_POLICY_READER_H_
