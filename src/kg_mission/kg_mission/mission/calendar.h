// The time windows of a mission, and look-up of those in which a fact applies.

#ifndef KG_MISSION_MISSION_CALENDAR_H_
#define KG_MISSION_MISSION_CALENDAR_H_

#include <map>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

class WindowCalendar {
 public:
  // A window ends at time:hasEnd, else after its duration, else at the begin of
  // the next window. All members throw InputError.
  WindowCalendar(const kg_core::GraphView& view, const FactEntity& mission);

  // The windows within the horizon, by index. Facts about later windows are
  // read but not kept.
  const std::vector<TimeWindow>& planned() const { return planned_; }
  bool IsPlanned(int window) const {
    return window < static_cast<int>(planned_.size());
  }

  // The windows named by an entity, sorted.
  std::vector<int> FindWindows(const FactEntity& entity,
                               const kg_core::Term& property) const;
  int FindWindow(const FactEntity& entity) const;  // ex:forWindow, exactly one.

  // The windows among `named` (empty: all) that begin while the facts about
  // `entity` are valid; {kNoWindow} if there is none.
  std::vector<int> Alive(const FactEntity& entity,
                         std::vector<int> named) const;
  static constexpr int kNoWindow = -1;

 private:
  void Complete(const kg_core::GraphView& view, int i);
  void LimitHorizon(const FactEntity& mission);

  std::vector<TimeWindow> planned_;
  std::map<std::string, int> index_of_;  // Index by IRI, for all windows.
};

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_CALENDAR_H_
