// Answer of a what-if: the artifacts an update would recompile, the resulting
// plan, and the differences from the present.

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

// Effect on one agent's path.
struct PathChange {
  std::string agent;  // ex:id.
  std::string agent_iri;
  bool changed = false;    // Stops or values of `after` and `before` differ.
  std::string infeasible;  // Why the present path could not be flown any more;
                           // empty: it could.
  // Energy of the present path in the hypothetical world; NaN = infeasible.
  double energy_needed_j = std::numeric_limits<double>::quiet_NaN();
  // Hypothetical budget for the windows still planned.
  double energy_budget_j = std::numeric_limits<double>::quiet_NaN();
  kg_selector::Pathlet before;  // No visits = none.
  kg_selector::Pathlet after;
  std::string
      unassigned;  // Why there is no hypothetical path; empty: there is.
};

// Effect on one traverse edge of the present graphs.
struct EdgeChange {
  std::string agent;  // ex:id.
  int window = 0;     // The edge leads into it.
  std::string edge;   // IRI of the ex:TraverseEdge in the present graphs.
  kg_base::LonLat from;
  kg_base::LonLat to;
  bool infeasible = false;  // No longer feasible.
  kg_compiler::EdgeCost before;
  kg_compiler::EdgeCost after;  // All NaN if infeasible.
};

struct WhatIfAnswer {
  bool ok = false;
  std::vector<std::string>
      errors;  // Reasons of rejection, as for a real update.
  std::uint64_t world_version = 0;  // Version of the forked world.
  std::vector<RecompiledArtifact> dirty;
  kg_selector::CommittedPlan plan;  // Hypothetical plan.
  double reward_change = 0.0;
  double energy_change_j = 0.0;
  std::string result;             // Query result: JSON, or Turtle for a graph.
  std::string text;               // Display text.
  std::vector<PathChange> paths;  // Changes of every agent, by id.
  // Number of edges of the present graphs; of these: infeasible, with higher
  // and with lower seam cost.
  std::size_t edges = 0;
  std::size_t edges_infeasible = 0;
  std::size_t edges_dearer = 0;
  std::size_t edges_cheaper = 0;
  // Infeasible first, then by increase of seam cost; at most 1000.
  std::vector<EdgeChange> changed_edges;
  // "facts", "base", "compile", "plan", "compare", "query".
  std::vector<kg_selector::StageTime> stages;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_ANSWER_H_
