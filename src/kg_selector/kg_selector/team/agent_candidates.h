// One agent's candidates with what they answer: a round of a cycle.

#ifndef KG_SELECTOR_TEAM_AGENT_CANDIDATES_H_
#define KG_SELECTOR_TEAM_AGENT_CANDIDATES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/coordinator.h"

namespace kg_selector {

struct AgentCandidates {
  double time_s = 0.0;  // When they were made, Unix seconds.
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::string agent;  // ex:id.
  std::string agent_iri;
  std::uint32_t round = 0;  // 0: unmasked; later ones answer a RoundRequest.
  AgentOffer found;
  std::vector<StageTime> stages;  // "nav_graphs", "stitch".
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_AGENT_CANDIDATES_H_
