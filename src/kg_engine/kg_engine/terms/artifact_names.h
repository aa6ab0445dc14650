// IRIs of compiled artifacts and of their inputs, and look-up of artifacts in a
// compilation.

#ifndef KG_ENGINE_TERMS_ARTIFACT_NAMES_H_
#define KG_ENGINE_TERMS_ARTIFACT_NAMES_H_

#include <cstdint>
#include <string>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/term.h"
#include "kg_mission/mission/mission.h"

namespace kg_engine {

// IRI from an artifact's hash and sources; the agent's ex:id and the window
// make it readable.
kg_core::Term TensorNode(const kg_compiler::MissionTensor& tensor,
                         const kg_mission::Mission& mission);
kg_core::Term SeamRulesNode(const kg_compiler::SeamRules& rules);
kg_core::Term StateNodeOf(const std::string& agent_id, std::uint64_t cycle);
kg_core::Term CompileNode(const std::string& plane, std::uint64_t cycle);

// The tensor of (agent, window), or null.
const kg_compiler::MissionTensor* FindTensor(
    const kg_compiler::Compilation& compilation, const std::string& agent_iri,
    int window);
const kg_compiler::SeamRules* FindRules(
    const kg_compiler::Compilation& compilation, const std::string& agent_iri);
// The window's IRI; a generated one for a window that no longer exists.
kg_core::Term WindowTerm(const kg_mission::Mission& mission, int window);

// Node of the commitment of an agent by the plan of a run.
kg_core::Term CommitmentNode(std::uint64_t run, const std::string& agent_id);

}  // namespace kg_engine

#endif  // KG_ENGINE_TERMS_ARTIFACT_NAMES_H_
