// The facts that a mission tensor of one (agent, window) reads, selected once
// for the masks, the blend, the hash and the provenance, so that the four
// agree.

#ifndef KG_COMPILER_DATA_PLANE_ACTIVE_FACTS_H_
#define KG_COMPILER_DATA_PLANE_ACTIVE_FACTS_H_

#include <string>
#include <vector>

#include "kg_mission/mission/mission.h"

namespace kg_compiler {

struct ActiveConstraint {
  const kg_mission::Constraint* fact = nullptr;
  // Effect of its kind, or the stricter one if the agent must avoid it.
  const kg_mission::ConstraintEffect* effect = nullptr;
  double attenuation = 1.0;  // Factor with the policy's override applied.
  // IRIs of the facts stating that the agent must avoid it (A11).
  std::vector<std::string> avoided_by;
  std::string override_iri;  // The ex:SoftOverride applied, if any.

  bool forbids() const { return effect->forbids; }
};

struct ActivePrior {
  const kg_mission::PriorLayer* fact = nullptr;
  double beta = 0.0;
  std::string weight_iri{};  // The ex:PriorWeight that defines beta.
};

struct ActiveFacts {
  bool reads_value = false;  // B_t is needed (alpha or gamma not 0).
  bool names_agent = false;  // Some fact applies by naming the agent.
  std::vector<ActiveConstraint> constraints;
  std::vector<ActivePrior> priors;
  std::vector<const kg_mission::Event*> events;  // Empty if beta_poi is 0.
};

// Points into `mission`, which must outlive the result. A soft zone forbids if
// the agent must avoid it, as inferred by rules or stated by an operator.
ActiveFacts FindActiveFacts(const kg_mission::Mission& mission,
                            const kg_mission::Agent& agent,
                            const kg_mission::TimeWindow& window);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_ACTIVE_FACTS_H_
