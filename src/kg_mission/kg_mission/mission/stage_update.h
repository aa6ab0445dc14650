// A fact update (facts/fact_update.h), parsed, checked against vocabulary and
// shapes, and applied or rejected as a whole.

#ifndef KG_MISSION_MISSION_STAGE_UPDATE_H_
#define KG_MISSION_MISSION_STAGE_UPDATE_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/facts/fact_update.h"
#include "kg_core/facts/update_log.h"
#include "kg_core/rdf/store.h"
#include "kg_core/shacl/violation.h"

namespace kg_mission {

// Stages the update's changes in `transaction` (facts graph): `replaces_facts`
// first, which leaves what files have stated; then `remove`,
// then `set`, `add`, `turtle` and `sparql`; then what follows from them
// (derived_facts.h) and what the rules conclude (mission_rules.h). Returns the
// reasons to refuse it; empty = none. With reasons, the transaction is half
// done and to be dropped. Knows nothing of files: see ingest.h. What an earlier
// ingest stated is dropped if IngestIsDue.
//  - malformed terms or Turtle, with the position;
//  - a property that the ontology does not know, with the nearest known name;
//  - `remove` of a fact that is not there;
//  - violations of the shapes in the state after it, e.g. an agent whose policy
//    does not exist, a confidence of 1.2, malformed WKT; only what the change
//    can have touched is checked (ValidateChange, validator.h);
//  - a rule that cannot be used, or whose conclusions are no facts that the
//    above would let pass (conclusions.h);
//  - two with one key, e.g. two costs of an edge for one agent (keys.h);
//  - a mission that can no longer be read (mission_reader.h).
std::vector<std::string> StageUpdate(const kg_core::FactUpdate& update,
                                     kg_core::Transaction& transaction);

// The same, with the violations of shapes themselves, even where the reasons
// are others; nothing if the update could not be read and applied.
struct UpdateJudgement {
  std::vector<std::string> reasons;
  std::optional<std::vector<kg_core::Violation>> violations;
};
UpdateJudgement JudgeUpdate(const kg_core::FactUpdate& update,
                            kg_core::Transaction& transaction);

// StageUpdate for a file of facts, whose name stands in the reasons, e.g. a
// mission's mission.ttl.
std::vector<std::string> StageFactsFile(const std::string& path,
                                        kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_STAGE_UPDATE_H_
