#include "kg_compiler/control_plane/nav_graph.h"

#include <stdexcept>

#include "kg_compiler/control_plane/window_graph.h"
#include "kg_core/base/input_error.h"
#include "kg_core/geo/wkt.h"

namespace kg_compiler {
namespace {

void CheckWorlds(const SeamRules& rules,
                 const std::vector<WindowWorld>& worlds) {
  if (worlds.size() != rules.windows.size()) {
    throw std::logic_error("as many worlds as windows are wanted");
  }
  for (const WindowWorld& world : worlds) {
    if (!world.tensor || !world.field ||
        world.tensor->grid.size() != world.field->grid.size()) {
      throw std::logic_error("tensor and field are not on one grid");
    }
  }
}

std::string Where(const SeamRules& rules, const WindowRules& window) {
  return "agent " + rules.agent_id + " (" + rules.agent_iri + "), window " +
         std::to_string(window.window) + " (" + window.iri + "): ";
}

const NavGraph* FindByHash(const std::vector<NavGraph>& graphs,
                           const std::string& hash) {
  for (const NavGraph& graph : graphs) {
    if (graph.hash == hash) return &graph;
  }
  return nullptr;
}

NavGraph CompileWindow(const WindowInputs& inputs,
                       const std::vector<NavGraph>& previous) {
  const NavGraph* same = FindByHash(previous, WindowGraphHash(inputs));
  if (same) return *same;
  NavGraph graph = BuildWindowGraph(inputs);
  if (graph.waypoints.empty()) {
    throw kg_core::InputError(
        Where(*inputs.rules, *inputs.window) +
        "there is nowhere the agent can be when the window ends: no open cell "
        "within reach where it can hold station");
  }
  return graph;
}

}  // namespace

double SeamCost(const SeamWeights& weights, const Flight& flight,
                double confidence) {
  return weights.time_per_s * flight.travel_s +
         weights.energy_per_j * flight.energy_j +
         weights.risk_per_s * flight.hazard_s +
         weights.uncertainty * (1.0 - confidence);
}

std::vector<NavGraph> CompileNavGraphs(const SeamRules& rules,
                                       const std::vector<WindowWorld>& worlds,
                                       const std::vector<NavGraph>& previous) {
  CheckWorlds(rules, worlds);
  std::vector<NavGraph> graphs;
  std::vector<kg_core::LonLat> sources = {rules.start};
  if (!worlds.empty() && !IsOpenAt(*worlds[0].tensor, rules.start)) {
    throw kg_core::InputError(
        Where(rules, rules.windows[0]) + "starts at " +
        kg_core::PointWkt(rules.start) +
        ", which is on land, in a no_go area or off the grid");
  }
  for (std::size_t t = 0; t < worlds.size(); ++t) {
    graphs.push_back(CompileWindow(
        {&rules, &rules.windows[t], worlds[t], sources}, previous));
    sources.clear();
    for (const Waypoint& waypoint : graphs.back().waypoints) {
      sources.push_back(waypoint.position);
    }
  }
  return graphs;
}

}  // namespace kg_compiler
