// Compiled artifacts as facts of the provenance graph: every artifact once,
// with the activity that made it and its exact inputs. A later cycle that
// reuses an artifact refers to the existing facts.
//
//   ex:tensor\/alpha\/w2\/<id>  a ex:HeatmapArtifact ; ex:hash ;
//       prov:wasDerivedFrom ... ; prov:wasGeneratedBy ex:compile\/phi2\/12
//   ex:rules\/alpha\/<id>       a ex:SeamRules ; ex:hash ;
//       prov:wasDerivedFrom ... ; prov:wasGeneratedBy ex:compile\/phi1\/12
//   ex:state\/alpha\/12         a ex:AgentState, as reported when cycle 12
//   began

#ifndef KG_ENGINE_FACTS_ARTIFACT_FACTS_H_
#define KG_ENGINE_FACTS_ARTIFACT_FACTS_H_

#include <cstdint>
#include <string>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_engine/terms/artifact_names.h"
#include "kg_mission/mission/mission.h"

namespace kg_engine {

// Whether the provenance graph describes `node`.
bool IsDescribed(const kg_core::GraphView& view, const kg_core::Term& node);

// Times of the planes' work on a cycle [Unix s].
struct CompileTimes {
  double began_s = 0.0;
  double tensors_s = 0.0;  // End of Phi 2.
  double ended_s = 0.0;    // End of Phi 1.
};

// Stages the facts missing from the provenance graph about a cycle's tensors
// and seam rules, with the activities that made them.
void StageArtifacts(const kg_compiler::Compilation& compilation,
                    std::uint64_t cycle, const CompileTimes& times,
                    kg_core::Transaction* transaction);

// Stages the places to which the plan of a run commits an agent.
void StageCommitment(std::uint64_t run, const kg_compiler::SeamRules& rules,
                     kg_core::Transaction* transaction);

// Stages the state that an agent had reported when a cycle began.
void StageReportedState(const kg_mission::Agent& agent, const AgentPose& pose,
                        std::uint64_t cycle, kg_core::Transaction* transaction);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_ARTIFACT_FACTS_H_
