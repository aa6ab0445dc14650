#include "kg_compiler/compile/same_compilation.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>
#include <utility>

#include "kg_base/common/parallel.h"

namespace kg_compiler {
namespace {

bool SameBits(const kg_base::Raster& a, const kg_base::Raster& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

bool Same(const MissionTensor& a, const MissionTensor& b) {
  if (a.agent_iri != b.agent_iri || a.window != b.window ||
      a.confidence != b.confidence || a.grid != b.grid || a.hash != b.hash ||
      a.derived_from != b.derived_from) {
    return false;
  }
  for (const Layer layer :
       {Layer::kReward, Layer::kUncertainty, Layer::kPolicy,
        Layer::kAttenuation, Layer::kFeasibility, Layer::kFused}) {
    if (a.Has(layer) != b.Has(layer)) return false;
    if (a.Has(layer) && !SameBits(a.Get(layer), b.Get(layer))) return false;
  }
  return true;
}

bool Same(const WorkField& a, const WorkField& b) {
  const auto same_slice = [](const kg_base::FieldSlice& x,
                             const kg_base::FieldSlice& y) {
    return x.time_s == y.time_s && SameBits(x.east_mps, y.east_mps) &&
           SameBits(x.north_mps, y.north_mps);
  };
  return a.window == b.window && a.iri == b.iri && a.hash == b.hash &&
         a.field.grid == b.field.grid &&
         std::equal(a.field.slices.begin(), a.field.slices.end(),
                    b.field.slices.begin(), b.field.slices.end(), same_slice);
}

bool Same(const SeamRules& a, const SeamRules& b) {
  return SameButForWindows(a, b) && a.windows == b.windows &&
         a.start_iri == b.start_iri && a.read_facts == b.read_facts;
}

bool Same(const NavGraph& a, const NavGraph& b);

std::string NameOf(const MissionTensor& tensor) {
  return "tensor of " + tensor.agent_iri + ", window " +
         std::to_string(tensor.window);
}
std::string NameOf(const WorkField& field) {
  return "work field " + field.iri + " of window " +
         std::to_string(field.window);
}
std::string NameOf(const SeamRules& rules) {
  return "seam rules of " + rules.agent_iri;
}
std::string NameOf(const NavGraph& graph) {
  return "nav graph of " + graph.agent_iri + ", window " +
         std::to_string(graph.window);
}

// Pairs of artifacts by name; null = only the other side has it.
template <typename T>
using Pairs = std::map<std::string, std::pair<const T*, const T*>>;

template <typename T>
void CompareAll(const Pairs<T>& pairs, Difference* found) {
  std::vector<typename Pairs<T>::const_iterator> all;
  for (auto at = pairs.begin(); at != pairs.end(); ++at) all.push_back(at);
  std::vector<unsigned char> same(all.size());
  kg_base::ForEachInParallel(all.size(), [&](std::size_t i) {
    const auto [a, b] = all[i]->second;
    same[i] = a && b && Same(*a, *b);
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!same[i]) found->differs.push_back(all[i]->first);
  }
  found->compared += all.size();
}

const MissionTensor& Value(const std::shared_ptr<const MissionTensor>& p) {
  return *p;
}
const WorkField& Value(const std::shared_ptr<const WorkField>& p) { return *p; }
const SeamRules& Value(const SeamRules& rules) { return rules; }
const NavGraph& Value(const NavGraph& graph) { return graph; }

template <typename T, typename List>
Pairs<T> PairUp(const List& a, const List& b) {
  Pairs<T> pairs;
  for (const auto& one : a) pairs[NameOf(Value(one))].first = &Value(one);
  for (const auto& one : b) pairs[NameOf(Value(one))].second = &Value(one);
  return pairs;
}

bool Same(const TimedPoint& a, const TimedPoint& b) {
  return a.position == b.position && a.time_s == b.time_s;
}

bool Same(const TraverseEdge& a, const TraverseEdge& b) {
  const auto tie = [](const TraverseEdge& e) {
    return std::tie(e.from, e.to, e.seam_cost, e.isolation_s, e.turn_rad,
                    e.flight.travel_s, e.flight.energy_j, e.flight.hazard_s,
                    e.flight.through_water_m);
  };
  const auto same_point = [](const TimedPoint& x, const TimedPoint& y) {
    return Same(x, y);
  };
  return tie(a) == tie(b) && a.via == b.via &&
         std::equal(a.flight.track.begin(), a.flight.track.end(),
                    b.flight.track.begin(), b.flight.track.end(), same_point);
}

bool Same(const std::vector<TraverseEdge>& a,
          const std::vector<TraverseEdge>& b) {
  const auto same = [](const TraverseEdge& x, const TraverseEdge& y) {
    return Same(x, y);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool Same(const Waypoint& a, const Waypoint& b) {
  return a.id == b.id && a.position == b.position && a.score == b.score &&
         a.value == b.value && a.events == b.events &&
         a.event_reward == b.event_reward && a.footprint == b.footprint;
}

bool Same(const NavGraph& a, const NavGraph& b) {
  const auto same = [](const Waypoint& x, const Waypoint& y) {
    return Same(x, y);
  };
  return a.agent_iri == b.agent_iri && a.window == b.window &&
         a.movement_mode == b.movement_mode && a.hash == b.hash &&
         std::equal(a.waypoints.begin(), a.waypoints.end(), b.waypoints.begin(),
                    b.waypoints.end(), same) &&
         Same(a.edges, b.edges) && Same(a.inner_edges, b.inner_edges);
}

}  // namespace

Difference Compare(const Compilation& a, const Compilation& b) {
  Difference found;
  CompareAll(PairUp<WorkField>(a.fields, b.fields), &found);
  CompareAll(PairUp<MissionTensor>(a.tensors, b.tensors), &found);
  CompareAll(PairUp<SeamRules>(a.rules, b.rules), &found);
  ++found.compared;
  if (!(a.coordination.facts == b.coordination.facts) ||
      a.coordination.event_capacity != b.coordination.event_capacity ||
      a.coordination.event_windows != b.coordination.event_windows) {
    found.differs.push_back("coordination rules");
  }
  return found;
}

Difference Compare(const NavGraphs& a, const NavGraphs& b) {
  Difference found;
  CompareAll(PairUp<NavGraph>(a, b), &found);
  return found;
}

}  // namespace kg_compiler
