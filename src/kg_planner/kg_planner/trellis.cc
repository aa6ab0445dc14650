#include "kg_planner/trellis.h"

#include "kg_planner/survey.h"

namespace kg_planner {

void Check(const Trellis& trellis) { CheckAndSurvey(trellis); }

}  // namespace kg_planner
