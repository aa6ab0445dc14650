// What would change under hypothetical facts. The world is forked, the update
// checked and staged as a real one, what is dirty compiled, and the plan made
// in process as the nodes would; then both worlds are compared. Nothing of the
// world itself is written.
//
// The query sees the hypothetical world, with plan facts as a committed plan
// has them (plan_facts.h), in graphs of the fork:
//   ex:graph/plan/what_if   the hypothetical plan; in the default graph, too
//   ex:graph/plan/present   the plan without the update, made in the same way
//   ex:graph/plan/repriced  ex:EdgeCost of the present plan's ex:TraverseEdges
//                           in the hypothetical world; one that is missing
//                           could not be flown any more

#ifndef KG_ENGINE_WHAT_IF_WHAT_IF_H_
#define KG_ENGINE_WHAT_IF_WHAT_IF_H_

#include <memory>
#include <string>

#include "kg_engine/state/start_state.h"
#include "kg_engine/what_if/edge_prices.h"
#include "kg_engine/what_if/what_if_answer.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/stage_update.h"

namespace kg_engine {

inline constexpr char kWhatIfPlan[] = "what_if";
inline constexpr char kPresentPlan[] = "present";
inline constexpr char kRepriced[] = "repriced";

struct WhatIfQuestion {
  kg_core::FactUpdate update;
  std::string query;          // SPARQL; may be empty.
  double time_limit_s = 0.0;  // Wall-clock; not positive: 60 s.
};

class WhatIf {
 public:
  // `files` must outlive this.
  explicit WhatIf(kg_mission::FileCache* files) : files_(files) {}

  // Never throws for what the question says: that is in `errors`. The plan of
  // the present is kept from one question to the next as long as it holds.
  WhatIfAnswer Ask(const Present& present, const WhatIfQuestion& question);

 private:
  struct Base {
    std::string key;  // Of all that the plan depends on.
    PlannedWorld world;
    kg_compiler::MissionCompiler compiler;
  };
  class Inquiry;
  std::shared_ptr<const Base> PlanPresent(const Present& present);

  kg_mission::FileCache* files_;
  std::shared_ptr<const Base> base_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_H_
