// One agent's candidates, with the cycle and round they answer.

#ifndef KG_SELECTOR_TEAM_AGENT_CANDIDATES_H_
#define KG_SELECTOR_TEAM_AGENT_CANDIDATES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/coordinator.h"

namespace kg_selector {

struct AgentCandidates {
  double time_s = 0.0;  // Creation time [Unix s].
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::string agent;  // ex:id.
  std::string agent_iri;
  std::uint32_t round = 0;  // 0 = unmasked; > 0 answers a RoundRequest.
  AgentOffer found;
  std::vector<StageTime> stages;  // "nav_graphs", "stitch".
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_AGENT_CANDIDATES_H_
