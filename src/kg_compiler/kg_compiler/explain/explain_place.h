// Why an agent cannot use a place in a window, with the margin by which it
// fails:
//
//   forbidden     metres to the nearest open cell; each constraint contributes
//                 its increment over the preceding ones
//   unreachable   seconds by which the least travel time found exceeds the time
//                 allowed by the window or the base travel
//   unholdable    m/s by which the strongest current there, in the window's
//                 data, exceeds the maximum speed
//
// Least travel times come from the search that finds waypoints (traversal.h),
// with increasing deadlines, in the window's own currents and areas.

#ifndef KG_COMPILER_EXPLAIN_EXPLAIN_PLACE_H_
#define KG_COMPILER_EXPLAIN_EXPLAIN_PLACE_H_

#include <optional>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/explain/cited_facts.h"
#include "kg_compiler/explain/explain_seam.h"
#include "kg_compiler/explain/explain_tensor.h"
#include "kg_compiler/explain/explanation.h"

namespace kg_compiler {

struct PlaceQuestion {
  TensorInputs tensor;
  SeamContext seam;
  std::vector<kg_base::LonLat> sources;  // Possible positions at begin.
  kg_base::LonLat place;
};

// Nullopt if a flight to the place exists.
std::optional<Explanation> WhyUnreachable(const PlaceQuestion& question,
                                          const CitedFacts& facts);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLAIN_PLACE_H_
