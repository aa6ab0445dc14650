#include "kg_ros/knowledge/artifact_facts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "kg_core/base/sha256.h"
#include "kg_core/base/units.h"
#include "kg_core/facts/terms.h"
#include "kg_ros/knowledge/fact_writer.h"
#include "kg_ros/knowledge/plan_facts.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;
using kg_compiler::MissionTensor;
using kg_compiler::SeamRules;
using kg_core::Ex;
using kg_core::Iri;
using kg_core::Prov;
using kg_core::Term;

constexpr std::size_t kIdDigits = 16;

// Short, of content and sources.
std::string Id(const std::string& hash,
               const std::vector<std::string>& sources) {
  kg_core::Hasher hasher;
  hasher.Add(hash);
  for (const std::string& source : sources) hasher.Add(source);
  return hasher.Hex().substr(0, kIdDigits);
}

std::string AgentId(const kg_core::Mission& mission,
                    const std::string& agent_iri) {
  const kg_core::Agent* agent = mission.FindAgent(agent_iri);
  return agent == nullptr ? "nobody" : agent->id;
}

// One activity of a plane, stated with the first artifact that it made.
class Plane {
 public:
  Plane(Term activity, kg_core::Transaction* transaction)
      : activity_(std::move(activity)),
        transaction_(transaction),
        write_(Iri(kg_core::kProvGraph)) {}

  const Term& activity() const { return activity_; }

  // Goes on with the artifact's statements; null if it is known already.
  FactWriter* Make(const Term& node, const char* type) {
    if (IsDescribed(transaction_->view(), node)) return nullptr;
    made_ = true;
    return &write_.About(node, type).GeneratedBy(activity_);
  }
  void Used(const std::vector<std::string>& sources) {
    used_.insert(sources.begin(), sources.end());
  }
  void Finish(const char* type, double started_s, double ended_s,
              std::uint64_t world_version) {
    if (!made_) return;
    write_.Activity(activity_, type, started_s, ended_s)
        .Integer("worldVersion", static_cast<long long>(world_version));
    for (const std::string& source : used_) write_.Used(Iri(source));
    AddAll(write_.Take(), transaction_);
  }

 private:
  Term activity_;
  kg_core::Transaction* transaction_;
  FactWriter write_;
  std::set<std::string> used_;
  bool made_ = false;
};

void MakeTensor(const MissionTensor& tensor, const kg_core::Mission& mission,
                Plane* plane) {
  FactWriter* write =
      plane->Make(TensorNode(tensor, mission), "HeatmapArtifact");
  if (write == nullptr) return;
  write->Link("forAgent", Iri(tensor.agent_iri))
      .Link("forWindow", WindowTerm(mission, tensor.window))
      .Text("tensorKind", "FUSED")
      .Text("hash", tensor.hash)
      .DerivedFrom(tensor.derived_from);
  plane->Used(tensor.derived_from);
}

void MakeRules(const SeamRules& rules, Plane* plane) {
  FactWriter* write = plane->Make(SeamRulesNode(rules), "SeamRules");
  if (write == nullptr) return;
  const std::vector<std::string> sources = kg_compiler::SeamRulesSources(rules);
  write->Link("forAgent", Iri(rules.agent_iri))
      .Text("hash", kg_compiler::SeamRulesHash(rules))
      .DerivedFrom(sources);
  for (const kg_compiler::WindowRules& window : rules.windows) {
    write->Link("forWindow", Iri(window.iri));
  }
  plane->Used(sources);
}

}  // namespace

Term TensorNode(const MissionTensor& tensor, const kg_core::Mission& mission) {
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

Term WindowTerm(const kg_core::Mission& mission, int window) {
  for (const kg_core::TimeWindow& known : mission.windows) {
    if (known.index == window) return Iri(known.iri);
  }
  return Ex("window/" + std::to_string(window));
}

bool IsDescribed(const kg_core::GraphView& view, const Term& node) {
  return kg_core::FirstObject(view, kg_core::kProvGraph, node,
                              kg_core::RdfType())
      .has_value();
}

void StageArtifacts(const Compilation& compilation, const std::uint64_t cycle,
                    const CompileTimes& times,
                    kg_core::Transaction* transaction) {
  Plane phi2(CompileNode("phi2", cycle), transaction);
  for (const auto& tensor : compilation.tensors) {
    MakeTensor(*tensor, compilation.mission, &phi2);
  }
  phi2.Finish("CompilePhi2", times.began_s, times.tensors_s,
              compilation.world_version);
  Plane phi1(CompileNode("phi1", cycle), transaction);
  for (const SeamRules& rules : compilation.rules) MakeRules(rules, &phi1);
  phi1.Finish("CompilePhi1", times.tensors_s, times.ended_s,
              compilation.world_version);
}

Term CommitmentNode(const std::uint64_t run, const std::string& agent_id) {
  return Iri(PlanRunNode(run).text + "/commitment/" + agent_id);
}

void StageCommitment(const std::uint64_t run, const SeamRules& rules,
                     kg_core::Transaction* transaction) {
  FactWriter write(Iri(kg_core::kProvGraph));
  write.About(CommitmentNode(run, rules.agent_id), "Commitment")
      .Link("forAgent", Iri(rules.agent_iri))
      .GeneratedBy(PlanRunNode(run))
      .GeneratedBy(SelectRunNode(run));
  AddAll(write.Take(), transaction);
}

void StageReportedState(const kg_core::Agent& agent, const AgentPose& pose,
                        const std::uint64_t cycle,
                        kg_core::Transaction* transaction) {
  FactWriter write(Iri(kg_core::kProvGraph));
  write.About(StateNodeOf(agent.id, cycle), "AgentState")
      .Link("forAgent", Iri(agent.iri))
      .Position(kg_core::GeoTerm("asWKT"), pose.position)
      .Number("headingDeg", kg_core::RadToDeg(pose.heading_rad))
      .Time(Iri(std::string(kg_core::kSosa) + "resultTime"), pose.time_s)
      .Add(Prov("wasAttributedTo"), Iri(agent.iri));
  if (!std::isnan(pose.energy_left_j)) {
    write.Number("energyRemaining", pose.energy_left_j / kg_core::kJoulesPerWh);
  }
  AddAll(write.Take(), transaction);
}

}  // namespace kg_ros
