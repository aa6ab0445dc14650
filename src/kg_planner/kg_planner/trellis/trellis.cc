#include "kg_planner/trellis/trellis.h"

#include "kg_planner/trellis/survey.h"

namespace kg_planner {

void Check(const Trellis& trellis) { CheckAndSurvey(trellis); }

}  // namespace kg_planner
