// What a what-if answers: what an update would make to be compiled anew, the
// plan that would follow, and how both differ from the present.

#ifndef KG_ENGINE_WHAT_IF_WHAT_IF_ANSWER_H_
#define KG_ENGINE_WHAT_IF_WHAT_IF_ANSWER_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_engine/facts/recompiled_artifact.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/committed_plan.h"

namespace kg_engine {

// What would become of one agent's path.
struct PathChange {
  std::string agent;  // ex:id.
  std::string agent_iri;
  bool changed = false;    // Stops or figures of `after` are not `before`'s.
  std::string infeasible;  // Why the present path could not be flown any more;
                           // empty: it could.
  // Of the present path at hypothetical prices; NaN = it cannot be flown.
  double energy_needed_j = std::numeric_limits<double>::quiet_NaN();
  // Hypothetical, for the windows still planned.
  double energy_budget_j = std::numeric_limits<double>::quiet_NaN();
  kg_selector::Pathlet before;  // No visits = none.
  kg_selector::Pathlet after;
  std::string
      unassigned;  // Why there is no hypothetical path; empty: there is.
};

// What would become of one traverse edge of the present graphs.
struct EdgeChange {
  std::string agent;  // ex:id.
  int window = 0;     // The edge leads into it.
  std::string edge;   // IRI of the ex:TraverseEdge in the present graphs.
  kg_base::LonLat from;
  kg_base::LonLat to;
  bool infeasible = false;  // It could not be flown any more.
  kg_compiler::EdgeCost before;
  kg_compiler::EdgeCost after;  // All NaN if infeasible.
};

struct WhatIfAnswer {
  bool ok = false;
  std::vector<std::string>
      errors;  // Why not, as a real update would be refused.
  std::uint64_t world_version = 0;  // It was forked from.
  std::vector<RecompiledArtifact> dirty;
  kg_selector::CommittedPlan plan;  // The hypothetical one.
  double reward_change = 0.0;
  double energy_change_j = 0.0;
  std::string result;             // Of the query: JSON, or Turtle of a graph.
  std::string text;               // For a person.
  std::vector<PathChange> paths;  // Of every agent, by id.
  // Edges of the present graphs; of them: could not be flown any more, seam
  // cost would rise, and would fall.
  std::size_t edges = 0;
  std::size_t edges_infeasible = 0;
  std::size_t edges_dearer = 0;
  std::size_t edges_cheaper = 0;
  // Infeasible first, then by rise of seam cost; 1000 at most.
  std::vector<EdgeChange> changed_edges;
  // "facts", "base", "compile", "plan", "compare", "query".
  std::vector<kg_selector::StageTime> stages;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_ANSWER_H_
