// What has a place on the map: constraints, prior layers, events.

#ifndef KG_CORE_MISSION_AREA_READER_H_
#define KG_CORE_MISSION_AREA_READER_H_

#include "kg_core/mission/calendar.h"
#include "kg_core/mission/entity.h"
#include "kg_core/mission/mission.h"

namespace kg_core {

// All throw InputError. What applies in no window any more has the one window
// Calendar::kNoWindow; of an event it has none.
Constraint ReadConstraint(const WindowCalendar& calendar,
                          const FactEntity& entity);
PriorLayer ReadPrior(const WindowCalendar& calendar, const FactEntity& entity);
Event ReadEvent(const WindowCalendar& calendar, const FactEntity& entity);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_AREA_READER_H_
