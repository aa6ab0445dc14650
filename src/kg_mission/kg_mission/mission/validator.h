// SHACL validation of the facts. Shapes are in the vocabulary graph; validation
// runs on the state after a transaction, before it commits (requirements 1.2).
// https://www.w3.org/TR/shacl/ The engine, for any graphs: shacl/validation.h.
//
// Focus nodes and values are taken from the facts graph; classes are read from
// facts, vocabulary and provenance.

#ifndef KG_MISSION_MISSION_VALIDATOR_H_
#define KG_MISSION_MISSION_VALIDATOR_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/shacl/violation.h"

namespace kg_mission {

// Validates every focus node of `view`'s facts graph against the shapes of its
// vocabulary graph. Throws InputError if a shape itself cannot be used.
std::vector<kg_core::Violation> Validate(const kg_core::GraphView& view);

// The same for the state after `transaction`, provided that the state before
// had no violation: checks only the focus nodes that its changes can affect
// (shacl/changes.h), or everything if they affect the vocabulary.
std::vector<kg_core::Violation> ValidateChange(
    const kg_core::Transaction& transaction);

// The violations caused by the conclusions of the rules if treated as facts,
// provided that the facts of `view` alone have none.
std::vector<kg_core::Violation> ValidateConclusions(
    const kg_core::GraphView& view);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_VALIDATOR_H_
