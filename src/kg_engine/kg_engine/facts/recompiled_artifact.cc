#include "kg_engine/facts/recompiled_artifact.h"

namespace kg_engine {
namespace {

std::string FindHash(const kg_compiler::Compilation& compilation,
                     const kg_compiler::DirtyArtifact& dirty) {
  for (const auto& tensor : compilation.tensors) {
    if (dirty.kind == "tensor" && tensor->agent_iri == dirty.agent &&
        tensor->window == dirty.window) {
      return tensor->hash;
    }
  }
  for (const auto& field : compilation.fields) {
    if (dirty.kind == "work_field" && field->window == dirty.window) {
      return field->hash;
    }
  }
  return "";
}

}  // namespace

std::vector<RecompiledArtifact> ListRecompiled(
    const kg_compiler::Compilation& compilation) {
  std::vector<RecompiledArtifact> artifacts;
  for (const kg_compiler::DirtyArtifact& dirty : compilation.dirty) {
    const kg_mission::Agent* agent = compilation.mission.FindAgent(dirty.agent);
    artifacts.push_back({dirty.kind, agent == nullptr ? "" : agent->id,
                         dirty.window, FindHash(compilation, dirty)});
  }
  return artifacts;
}

}  // namespace kg_engine
