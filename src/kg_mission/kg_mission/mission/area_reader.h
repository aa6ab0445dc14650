// Reads the entities with a position on the map: constraints, prior layers,
// events.

#ifndef KG_MISSION_MISSION_AREA_READER_H_
#define KG_MISSION_MISSION_AREA_READER_H_

#include "kg_mission/mission/calendar.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// All throw InputError. An entity that no longer applies in any window gets the
// single window Calendar::kNoWindow; an event gets an empty list.
Constraint ReadConstraint(const WindowCalendar& calendar,
                          const FactEntity& entity);
PriorLayer ReadPrior(const WindowCalendar& calendar, const FactEntity& entity);
Event ReadEvent(const WindowCalendar& calendar, const FactEntity& entity);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_AREA_READER_H_
