#include "kg_mission/mission/calendar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kg_base/common/date_time.h"
#include "kg_base/common/units.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/validity.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::TimeTerm;

TimeWindow ReadWindow(const FactEntity& entity) {
  TimeWindow window;
  window.iri = entity.iri();
  window.index = entity.Integer(Ex("index"));
  const auto begin_s = entity.MaybeTime_s(TimeTerm("hasBeginning"));
  if (!begin_s) entity.Refuse(TimeTerm("hasBeginning"), "an xsd:dateTime");
  window.begin_s = *begin_s;
  window.end_s = std::nan("");
  const auto hours = entity.MaybeNumber(Ex("durationHours"));
  if (hours) window.end_s = window.begin_s + kg_base::HoursToSeconds(*hours);
  const auto end_s = entity.MaybeTime_s(TimeTerm("hasEnd"));
  if (end_s) window.end_s = *end_s;
  window.confidence = entity.Number(Ex("confidence"));
  return window;
}

}  // namespace

WindowCalendar::WindowCalendar(const kg_core::GraphView& view,
                               const FactEntity& mission) {
  for (const kg_core::Term& term : mission.All(Ex("hasWindow"))) {
    planned_.push_back(ReadWindow(FactEntity(view, term)));
  }
  std::sort(planned_.begin(), planned_.end(),
            [](const TimeWindow& a, const TimeWindow& b) {
              return a.index < b.index;
            });
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    Complete(view, static_cast<int>(i));
  }
  if (planned_.empty()) {
    mission.Refuse(Ex("hasWindow"), "at least one window");
  }
  LimitHorizon(mission);
}

void WindowCalendar::Complete(const kg_core::GraphView& view, int i) {
  TimeWindow& window = planned_[i];
  const FactEntity entity(view, kg_core::Iri(window.iri));
  if (window.index != i) {
    entity.Refuse(Ex("index"), std::to_string(i) +
                                   ": the windows' indices run from 0 " +
                                   "without gaps or duplicates");
  }
  const bool is_last = i + 1 == static_cast<int>(planned_.size());
  // Without end and duration the window lasts until the next one begins.
  if (std::isnan(window.end_s) && !is_last) {
    window.end_s = planned_[i + 1].begin_s;
  }
  if (!(window.end_s > window.begin_s)) {
    entity.Refuse(TimeTerm("hasEnd"),
                  "an end after the begin (time:hasEnd, ex:durationHours or "
                  "the next window's begin)");
  }
  if (!is_last && !(window.end_s <= planned_[i + 1].begin_s)) {
    entity.Refuse(TimeTerm("hasEnd"),
                  "an end by the next window's begin, " +
                      kg_base::FormatDateTime(planned_[i + 1].begin_s));
  }
}

void WindowCalendar::LimitHorizon(const FactEntity& mission) {
  const int count = static_cast<int>(planned_.size());
  const int horizon = mission.Integer(Ex("horizon"), count);
  if (!(horizon <= count)) {
    mission.Refuse(Ex("horizon"),
                   "at most the number of windows, " + std::to_string(count));
  }
  for (const TimeWindow& window : planned_) {
    index_of_[window.iri] = window.index;
  }
  planned_.resize(horizon);
}

std::vector<int> WindowCalendar::FindWindows(
    const FactEntity& entity, const kg_core::Term& property) const {
  std::vector<int> windows;
  for (const std::string& iri : entity.Iris(property)) {
    const auto found = index_of_.find(iri);
    if (found == index_of_.end()) {
      entity.Refuse(property, "a window of the mission, not " +
                                  kg_core::ToTurtle(kg_core::Iri(iri)));
    }
    windows.push_back(found->second);
  }
  std::sort(windows.begin(), windows.end());
  return windows;
}

int WindowCalendar::FindWindow(const FactEntity& entity) const {
  const std::vector<int> windows = FindWindows(entity, Ex("forWindow"));
  if (windows.size() != 1) entity.Refuse(Ex("forWindow"), "one window");
  return windows[0];
}

std::vector<int> WindowCalendar::Alive(const FactEntity& entity,
                                       std::vector<int> named) const {
  const double end_s = ValidUntil_s(entity);
  if (std::isinf(end_s)) return named;
  std::vector<int> alive;
  for (const TimeWindow& window : planned_) {
    const bool is_named =
        named.empty() ||
        std::count(named.begin(), named.end(), window.index) > 0;
    if (is_named && window.begin_s < end_s) alive.push_back(window.index);
  }
  return alive.empty() ? std::vector<int>{kNoWindow} : alive;
}

}  // namespace kg_mission
