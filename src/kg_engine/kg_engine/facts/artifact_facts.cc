#include "kg_engine/facts/artifact_facts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "kg_base/common/units.h"
#include "kg_core/facts/terms.h"
#include "kg_engine/facts/fact_writer.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using kg_compiler::Compilation;
using kg_compiler::MissionTensor;
using kg_compiler::SeamRules;
using kg_core::Ex;
using kg_core::Iri;
using kg_core::Prov;
using kg_core::Term;

// One activity of a plane, written with the first artifact that it made.
class Plane {
 public:
  Plane(Term activity, kg_core::Transaction* transaction)
      : activity_(std::move(activity)),
        transaction_(transaction),
        write_(Iri(kg_core::kProvGraph)) {}

  const Term& activity() const { return activity_; }

  // Begins the artifact's statements; null if it is already described.
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

void MakeTensor(const MissionTensor& tensor, const kg_mission::Mission& mission,
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

void StageCommitment(const std::uint64_t run, const SeamRules& rules,
                     kg_core::Transaction* transaction) {
  FactWriter write(Iri(kg_core::kProvGraph));
  write.About(CommitmentNode(run, rules.agent_id), "Commitment")
      .Link("forAgent", Iri(rules.agent_iri))
      .GeneratedBy(PlanRunNode(run))
      .GeneratedBy(SelectRunNode(run));
  AddAll(write.Take(), transaction);
}

void StageReportedState(const kg_mission::Agent& agent, const AgentPose& pose,
                        const std::uint64_t cycle,
                        kg_core::Transaction* transaction) {
  FactWriter write(Iri(kg_core::kProvGraph));
  write.About(StateNodeOf(agent.id, cycle), "AgentState")
      .Link("forAgent", Iri(agent.iri))
      .Position(kg_core::GeoTerm("asWKT"), pose.position)
      .Number("headingDeg", kg_base::RadToDeg(pose.heading_rad))
      .Time(Iri(std::string(kg_core::kSosa) + "resultTime"), pose.time_s)
      .Add(Prov("wasAttributedTo"), Iri(agent.iri));
  if (!std::isnan(pose.energy_left_j)) {
    write.Number("energyRemaining", pose.energy_left_j / kg_base::kJoulesPerWh);
  }
  AddAll(write.Take(), transaction);
}

}  // namespace kg_engine
