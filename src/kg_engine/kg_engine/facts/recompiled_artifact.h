// The artifacts that a compilation made anew, as others are told of them: by
// the agent's ex:id and with the hash of what was made.

#ifndef KG_ENGINE_FACTS_RECOMPILED_ARTIFACT_H_
#define KG_ENGINE_FACTS_RECOMPILED_ARTIFACT_H_

#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"

namespace kg_engine {

struct RecompiledArtifact {
  std::string kind;   // "tensor", "work_field", "seam_rules", "coordination".
  std::string agent;  // ex:id; empty: shared by all.
  int window = -1;    // -1: all windows.
  std::string hash;   // Of its inputs and parameters; empty: not known.
};

std::vector<RecompiledArtifact> ListRecompiled(
    const kg_compiler::Compilation& compilation);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_RECOMPILED_ARTIFACT_H_
