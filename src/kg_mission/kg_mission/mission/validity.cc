#include "kg_mission/mission/validity.h"

#include <algorithm>
#include <limits>

#include "kg_core/facts/terms.h"

namespace kg_mission {

double ValidUntil_s(const FactEntity& entity) {
  constexpr double kNever_s = std::numeric_limits<double>::infinity();
  double end_s = kNever_s;
  for (const char* name : kEndProperties) {
    end_s = std::min(end_s,
                     entity.MaybeTime_s(kg_core::Ex(name)).value_or(kNever_s));
  }
  return end_s;
}

}  // namespace kg_mission
