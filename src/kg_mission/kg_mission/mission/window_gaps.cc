#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_mission/mission/mission_reader.h"

namespace kg_mission {

std::vector<std::string> WindowGaps(const Mission& mission) {
  std::vector<std::string> gaps;
  for (std::size_t i = 1; i < mission.windows.size(); ++i) {
    const TimeWindow& before = mission.windows[i - 1];
    const TimeWindow& after = mission.windows[i];
    if (!(after.begin_s > before.end_s)) continue;
    gaps.push_back(kg_core::AbbreviateIri(after.iri) + " begins " +
                   std::to_string(std::lround(after.begin_s - before.end_s)) +
                   " s after " + kg_core::AbbreviateIri(before.iri) +
                   " ends: nothing is planned in between");
  }
  return gaps;
}

}  // namespace kg_mission
