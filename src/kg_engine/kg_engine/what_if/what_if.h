// Effect of hypothetical facts. The world is forked, the update is checked and
// staged like a real one, dirty artifacts are compiled, and the plan is made in
// process as the nodes would; then both worlds are compared. The world itself
// is not modified.
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
  double time_limit_s = 0.0;  // Wall-clock; 60 s if not positive.
};

class WhatIf {
 public:
  // `files` must outlive this object.
  explicit WhatIf(kg_mission::FileCache* files) : files_(files) {}

  // Never throws for errors in the question: they are in `errors`. The plan of
  // the present is cached between questions while it is valid.
  WhatIfAnswer Ask(const Present& present, const WhatIfQuestion& question);

 private:
  struct Base {
    std::string key;  // Hash of all inputs of the plan.
    CompiledPlan world;
    kg_compiler::MissionCompiler compiler;
  };
  class Inquiry;
  std::shared_ptr<const Base> PlanPresent(const Present& present);

  kg_mission::FileCache* files_;
  std::shared_ptr<const Base> base_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_H_
