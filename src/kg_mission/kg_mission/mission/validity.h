// End of validity of the facts about an entity.

#ifndef KG_MISSION_MISSION_VALIDITY_H_
#define KG_MISSION_MISSION_VALIDITY_H_

#include "kg_mission/mission/entity.h"

namespace kg_mission {

// Properties in ex: that give the end of validity of the facts about their
// subject.
inline constexpr const char* kEndProperties[] = {"validUntil", "expires"};

// End of validity of the facts about `entity`, Unix seconds; the earlier one if
// there are two, infinity if none.
double ValidUntil_s(const FactEntity& entity);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_VALIDITY_H_
