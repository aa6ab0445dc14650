// What keeps an agent from a place in a window, with the margin it misses it
// by:
//
//   forbidden     metres to the nearest open cell; each constraint contributes
//                 what it adds to those before it
//   unreachable   seconds that the least travel time found exceeds what the
//                 window, or the base travel, allows
//   unholdable    m/s of current beyond the greatest speed when the window ends
//
// Least travel times come from the search that finds waypoints (traversal.h),
// with later and later deadlines, in the window's own currents and areas.

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
  std::vector<kg_base::LonLat> sources;  // Where the window may begin.
  kg_base::LonLat place;
};

// Nothing if a flight to the place exists.
std::optional<Explanation> WhyUnreachable(const PlaceQuestion& question,
                                          const CitedFacts& facts);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLAIN_PLACE_H_
