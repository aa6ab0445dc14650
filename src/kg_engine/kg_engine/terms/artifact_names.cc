#include "kg_engine/terms/artifact_names.h"

#include <vector>

#include "kg_base/common/sha256.h"
#include "kg_core/facts/terms.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using kg_compiler::Compilation;
using kg_compiler::MissionTensor;
using kg_compiler::SeamRules;
using kg_core::Ex;
using kg_core::Iri;
using kg_core::Term;

constexpr std::size_t kIdDigits = 16;

// Short id from content hash and sources.
std::string Id(const std::string& hash,
               const std::vector<std::string>& sources) {
  kg_base::Hasher hasher;
  hasher.Add(hash);
  for (const std::string& source : sources) hasher.Add(source);
  return hasher.Hex().substr(0, kIdDigits);
}

std::string AgentId(const kg_mission::Mission& mission,
                    const std::string& agent_iri) {
  const kg_mission::Agent* agent = mission.FindAgent(agent_iri);
  return agent == nullptr ? "nobody" : agent->id;
}

}  // namespace

Term TensorNode(const MissionTensor& tensor,
                const kg_mission::Mission& mission) {
  return Ex("tensor/" + AgentId(mission, tensor.agent_iri) + "/w" +
            std::to_string(tensor.window) + "/" +
            Id(tensor.hash, tensor.derived_from));
}

Term SeamRulesNode(const SeamRules& rules) {
  return Ex("rules/" + rules.agent_id + "/" +
            Id(kg_compiler::SeamRulesHash(rules),
               kg_compiler::SeamRulesSources(rules)));
}

Term StateNodeOf(const std::string& agent_id, const std::uint64_t cycle) {
  return Ex("state/" + agent_id + "/" + std::to_string(cycle));
}

Term CompileNode(const std::string& plane, const std::uint64_t cycle) {
  return Ex("compile/" + plane + "/" + std::to_string(cycle));
}

const MissionTensor* FindTensor(const Compilation& compilation,
                                const std::string& agent_iri, int window) {
  for (const auto& tensor : compilation.tensors) {
    if (tensor->agent_iri == agent_iri && tensor->window == window) {
      return tensor.get();
    }
  }
  return nullptr;
}

const SeamRules* FindRules(const Compilation& compilation,
                           const std::string& agent_iri) {
  for (const SeamRules& rules : compilation.rules) {
    if (rules.agent_iri == agent_iri) return &rules;
  }
  return nullptr;
}

Term WindowTerm(const kg_mission::Mission& mission, int window) {
  for (const kg_mission::TimeWindow& known : mission.windows) {
    if (known.index == window) return Iri(known.iri);
  }
  return Ex("window/" + std::to_string(window));
}

Term CommitmentNode(const std::uint64_t run, const std::string& agent_id) {
  return Iri(PlanRunNode(run).text + "/commitment/" + agent_id);
}

}  // namespace kg_engine
