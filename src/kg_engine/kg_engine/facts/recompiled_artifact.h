// Artifacts recompiled by a compilation, as reported to others: with the
// agent's ex:id and the hash of the result.

#ifndef KG_ENGINE_FACTS_RECOMPILED_ARTIFACT_H_
#define KG_ENGINE_FACTS_RECOMPILED_ARTIFACT_H_

#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"

namespace kg_engine {

struct RecompiledArtifact {
  std::string kind;   // "tensor", "work_field", "seam_rules", "coordination".
  std::string agent;  // ex:id; empty = shared by all.
  int window = -1;    // -1 = all windows.
  std::string hash;   // Hash of its inputs and parameters; empty = unknown.
};

std::vector<RecompiledArtifact> ListRecompiled(
    const kg_compiler::Compilation& compilation);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_RECOMPILED_ARTIFACT_H_
