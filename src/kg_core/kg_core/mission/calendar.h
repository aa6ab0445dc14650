// The windows of a mission, and which of them something applies in.

#ifndef KG_CORE_MISSION_CALENDAR_H_
#define KG_CORE_MISSION_CALENDAR_H_

#include <map>
#include <string>
#include <vector>

#include "kg_core/mission/entity.h"
#include "kg_core/mission/mission.h"
#include "kg_core/rdf/graph_view.h"

namespace kg_core {

class WindowCalendar {
 public:
  // A window ends at time:hasEnd, else after its duration, else at the next
  // begin. All throw InputError.
  WindowCalendar(const GraphView& view, const FactEntity& mission);

  // Those within the horizon, by index. Facts about later ones are read, but
  // nothing of them is kept.
  const std::vector<TimeWindow>& planned() const { return planned_; }
  bool IsPlanned(int window) const {
    return window < static_cast<int>(planned_.size());
  }

  // The windows that an entity names, sorted.
  std::vector<int> FindWindows(const FactEntity& entity,
                               const Term& property) const;
  int FindWindow(const FactEntity& entity) const;  // ex:forWindow, exactly one.

  // The windows among `named` (empty: all) that begin while the facts about
  // `entity` hold; {kNoWindow} if there is none.
  std::vector<int> Alive(const FactEntity& entity,
                         std::vector<int> named) const;
  static constexpr int kNoWindow = -1;

 private:
  void Complete(const GraphView& view, int i);
  void LimitHorizon(const FactEntity& mission);

  std::vector<TimeWindow> planned_;
  std::map<std::string, int> index_of_;  // Of all windows, by IRI.
};

}  // namespace kg_core

#endif  // KG_CORE_MISSION_CALENDAR_H_
