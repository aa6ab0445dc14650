// SHACL over the facts: shapes are Turtle in the vocabulary graph, validated on
// the state a transaction would leave, before it commits (requirements 1.2).
// https://www.w3.org/TR/shacl/ The engine, for any graphs: shacl/validation.h.
//
// Focus nodes and values are those of the facts graph; the classes of things
// are read from facts, vocabulary and provenance.

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

// The same for another graph, such as a plan's: its own focus nodes and values,
// classes also by the graphs above.
std::vector<kg_core::Violation> ValidateGraph(const kg_core::GraphView& view,
                                              const std::string& graph);

// The same for the state that `transaction` would leave, if the one it began
// with has no violation: only what its changes can have touched is checked
// (shacl/changes.h), or everything if they touch the vocabulary.
std::vector<kg_core::Violation> ValidateChange(
    const kg_core::Transaction& transaction);

// The violations that what rules conclude would bring, were it among the facts,
// if the facts of `view` alone have none.
std::vector<kg_core::Violation> ValidateConclusions(
    const kg_core::GraphView& view);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_VALIDATOR_H_
