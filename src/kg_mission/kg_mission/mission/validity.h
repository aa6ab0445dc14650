// Until when the facts about an entity hold.

#ifndef KG_MISSION_MISSION_VALIDITY_H_
#define KG_MISSION_MISSION_VALIDITY_H_

#include "kg_mission/mission/entity.h"

namespace kg_mission {

// Properties in ex: that say when the facts about their subject end.
inline constexpr const char* kEndProperties[] = {"validUntil", "expires"};

// When the facts about `entity` end, Unix seconds: the earlier of two; infinity
// if never.
double ValidUntil_s(const FactEntity& entity);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_VALIDITY_H_
