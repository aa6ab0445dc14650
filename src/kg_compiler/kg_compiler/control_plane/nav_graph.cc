#include "kg_compiler/control_plane/nav_graph.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/control_plane/seam_cache.h"
#include "kg_compiler/control_plane/window_graph.h"

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

// Why an agent may not start at a position of the first window.
std::string WhyClosed(const MissionTensor& tensor, kg_base::LonLat position) {
  const std::optional<kg_base::Cell> cell = tensor.grid.CellAt(position);
  if (!cell) return "off the grid (" + tensor.grid.Text() + ")";
  const float open = tensor.At(Layer::kFeasibility, tensor.grid.Index(*cell));
  return std::isnan(open) ? "on land: the work field has no data there"
                          : "in a no_go area or its buffer";
}

// Builds the graphs and the next cache from the last one.
class GraphBuilds {
 public:
  // `keep`: store the seams for the next call.
  GraphBuilds(const SeamRules& rules, const SeamCache& last, bool keep)
      : rules_(rules), last_(last), keep_(keep) {}

  const NavGraph& Add(const WindowInputs& inputs) {
    if (!TakeOver(WindowGraphHash(inputs), inputs.window->window)) {
      Build(inputs);
    }
    return now_.graphs.back();
  }
  SeamCache Take() { return std::move(now_); }

 private:
  const KeptSeams* LastSeams(int window) const {
    const auto found = last_.windows.find(window);
    return found == last_.windows.end() ? nullptr : found->second.get();
  }

  bool TakeOver(const std::string& hash, int window) {
    for (std::size_t i = 0; i < last_.graphs.size(); ++i) {
      if (last_.graphs[i].hash != hash) continue;
      now_.graphs.push_back(last_.graphs.Share(i));
      const auto seams = last_.windows.find(window);
      if (seams != last_.windows.end()) now_.windows.insert(*seams);
      ++now_.counts.graphs_kept;
      return true;
    }
    return false;
  }

  void Build(const WindowInputs& inputs) {
    const int window = inputs.window->window;
    BuiltWindow built =
        BuildWindowGraph(inputs, LastSeams(window), &now_.counts);
    if (built.graph.waypoints.empty()) {
      throw kg_base::InputError(
          Where(rules_, *inputs.window) +
          "there is nowhere the agent can be when the window ends: no open "
          "cell within reach where it can hold station");
    }
    now_.graphs.push_back(std::move(built.graph));
    if (keep_) now_.windows[window] = std::move(built.seams);
    ++now_.counts.graphs;
  }

  const SeamRules& rules_;
  const SeamCache& last_;
  bool keep_;
  SeamCache now_;
};

}  // namespace

NavGraphs CompileNavGraphs(const SeamRules& rules,
                           const std::vector<WindowWorld>& worlds,
                           SeamCache* cache) {
  CheckWorlds(rules, worlds);
  std::vector<kg_base::LonLat> sources = {rules.start};
  if (!worlds.empty() && !IsOpenAt(*worlds[0].tensor, rules.start)) {
    throw kg_base::InputError(Where(rules, rules.windows[0]) + "starts at " +
                              kg_base::PointWkt(rules.start) + ", which is " +
                              WhyClosed(*worlds[0].tensor, rules.start));
  }
  // The waypoints of a window are the departure places of the next one.
  const SeamCache none;
  GraphBuilds graphs(rules, cache ? *cache : none, cache != nullptr);
  for (std::size_t t = 0; t < worlds.size(); ++t) {
    sources = PositionsOf(
        graphs.Add({&rules, &rules.windows[t], worlds[t], sources}).waypoints);
  }
  SeamCache made = graphs.Take();
  NavGraphs result = made.graphs;
  if (cache) *cache = std::move(made);
  return result;
}

}  // namespace kg_compiler
