// The status of a recorded plan run among the facts (ex:status).

#ifndef KG_ENGINE_FACTS_PLAN_STATUS_H_
#define KG_ENGINE_FACTS_PLAN_STATUS_H_

#include <cstdint>

#include "kg_core/rdf/store.h"

namespace kg_engine {

// Replaces the status of a run ("stale", "superseded"), if its graph still
// exists.
void StagePlanStatus(std::uint64_t run, const char* status,
                     kg_core::Transaction* transaction);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_PLAN_STATUS_H_
