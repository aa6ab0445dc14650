#include "kg_engine/what_if/what_if_text.h"

#include <cstdio>
#include <map>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/units.h"

namespace kg_engine {
namespace {

template <typename... Values>
std::string Print(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double ToWh(double energy_j) { return energy_j / kg_base::kJoulesPerWh; }

std::string DirtyLine(const WhatIfAnswer& answer) {
  if (answer.dirty.empty()) return "nothing to recompile\n";
  std::map<std::string, int> counts;
  for (const RecompiledArtifact& dirty : answer.dirty) {
    const std::string of = dirty.agent.empty() ? "" : " of " + dirty.agent;
    ++counts[dirty.kind + of];
  }
  std::string line = "to recompile:";
  for (const auto& [what, count] : counts) {
    line +=
        (line.back() == ':' ? " " : ", ") + std::to_string(count) + " " + what;
  }
  return line + "\n";
}

std::string EdgesLine(const WhatIfAnswer& answer) {
  return Print(
      "traverse edges: %zu; %zu could not be flown any more, %zu dearer, "
      "%zu cheaper\n",
      answer.edges, answer.edges_infeasible, answer.edges_dearer,
      answer.edges_cheaper);
}

bool SamePlace(const kg_selector::Visit& a, const kg_selector::Visit& b) {
  return a.window == b.window && a.position == b.position;
}

// "windows 2, 3" with differing stops.
std::string OtherStops(const PathChange& change) {
  std::vector<std::string> windows;
  for (const kg_selector::Visit& visit : change.after.visits) {
    bool known = false;
    for (const kg_selector::Visit& old : change.before.visits) {
      known = known || SamePlace(visit, old);
    }
    if (!known) windows.push_back(std::to_string(visit.window));
  }
  if (windows.empty()) return "same stops";
  return "other stops in windows " + kg_base::JoinStrings(windows);
}

std::string PathLine(const PathChange& change) {
  if (change.after.visits.empty()) {
    return change.agent + ": no path" +
           (change.unassigned.empty() ? "" : ": " + change.unassigned) + "\n";
  }
  if (change.before.visits.empty()) {
    return change.agent +
           Print(": gets a path; reward %.2f, seam cost %.2f, energy %.1f Wh\n",
                 change.after.reward, change.after.seam_cost,
                 ToWh(change.after.energy_j));
  }
  if (!change.changed) return change.agent + ": the same path\n";
  return change.agent + ": " + OtherStops(change) +
         Print("; reward %.2f -> %.2f, seam cost %.2f -> %.2f, ",
               change.before.reward, change.after.reward,
               change.before.seam_cost, change.after.seam_cost) +
         Print("energy %.1f -> %.1f Wh\n", ToWh(change.before.energy_j),
               ToWh(change.after.energy_j));
}

std::string Changes(const WhatIfAnswer& answer) {
  std::string text = "what if, from world version " +
                     std::to_string(answer.world_version) + "\n" +
                     DirtyLine(answer) + EdgesLine(answer);
  for (const PathChange& change : answer.paths) {
    text += PathLine(change);
    if (change.infeasible.empty()) continue;
    text += "  its present path would become infeasible: " + change.infeasible +
            "\n";
  }
  return text + Print("team: reward %+.2f, energy %+.1f Wh\n",
                      answer.reward_change, ToWh(answer.energy_change_j));
}

}  // namespace

std::string WhatIfText(const WhatIfAnswer& answer) {
  std::string text;
  for (const std::string& error : answer.errors) text += error + "\n";
  if (!answer.paths.empty()) text += Changes(answer);
  return answer.text.empty() ? text : text + "\n" + answer.text;
}

}  // namespace kg_engine
