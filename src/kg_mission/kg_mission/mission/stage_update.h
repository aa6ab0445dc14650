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
// first, which keeps ingested facts; then `remove`, then `set`, `add`, `turtle`
// and `sparql`; then the derived facts (derived_facts.h) and the conclusions of
// the rules (mission_rules.h). Does not read files, see ingest.h; facts of an
// earlier ingest are dropped if IngestIsDue. Returns the reasons to reject the
// update; empty = none. If there are reasons, the transaction is incomplete and
// must be discarded. Reasons are:
//  - malformed terms or Turtle, with the position;
//  - a property unknown to the ontology, with the nearest known name;
//  - `remove` of a fact that does not exist;
//  - violations of the shapes in the resulting state, e.g. an agent whose
//    policy does not exist, a confidence of 1.2, malformed WKT; only nodes that
//    the change can affect are checked (ValidateChange, validator.h);
//  - an unusable rule, or one whose conclusions would be rejected as facts by
//    the checks above (conclusions.h);
//  - two instances with the same key, e.g. two costs of an edge for one agent
//    (keys.h);
//  - a mission that can no longer be read (mission_reader.h).
std::vector<std::string> StageUpdate(const kg_core::FactUpdate& update,
                                     kg_core::Transaction& transaction);

// Like StageUpdate, but also returns the shape violations, even if there are
// other reasons; nullopt if the update could not be parsed and applied.
struct UpdateJudgement {
  std::vector<std::string> reasons;
  std::optional<std::vector<kg_core::Violation>> violations;
};
UpdateJudgement JudgeUpdate(const kg_core::FactUpdate& update,
                            kg_core::Transaction& transaction);

// StageUpdate for a file of facts (e.g. mission.ttl of a mission), whose name
// is included in the reasons.
std::vector<std::string> StageFactsFile(const std::string& path,
                                        kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_STAGE_UPDATE_H_
