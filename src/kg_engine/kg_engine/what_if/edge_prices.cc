#include "kg_engine/what_if/edge_prices.h"

#include <map>
#include <utility>
#include <vector>

#include "kg_base/common/parallel.h"
#include "kg_compiler/control_plane/window_traversal.h"

namespace kg_engine {
namespace {

using kg_compiler::NavGraph;
using kg_compiler::SeamRules;
using kg_compiler::TraverseEdge;
using kg_compiler::WaypointRoute;
using kg_selector::TeamMember;

WaypointRoute WayOf(const TeamMember& member, std::size_t window,
                    const TraverseEdge& edge) {
  const auto& waypoints = member.graphs[window].waypoints;
  WaypointRoute way{BeginOf(member, window, edge), waypoints[edge.to].position};
  for (const int stop : edge.via) way.via.push_back(waypoints[stop].position);
  return way;
}

// All positions on the route, longitude and latitude alternating.
using Places = std::vector<double>;
Places PlacesOf(const WaypointRoute& way) {
  Places places = {way.from.lon_deg, way.from.lat_deg};
  for (const kg_base::LonLat& stop : way.via) {
    places.insert(places.end(), {stop.lon_deg, stop.lat_deg});
  }
  places.insert(places.end(), {way.to.lon_deg, way.to.lat_deg});
  return places;
}

std::optional<std::size_t> PlaceOf(const SeamRules& rules, int window) {
  for (std::size_t i = 0; i < rules.windows.size(); ++i) {
    if (rules.windows[i].window == window) return i;
  }
  return std::nullopt;
}

// Edges of one graph, by their positions.
std::map<Places, const TraverseEdge*> KnownPrices(const TeamMember& member,
                                                  std::size_t window) {
  std::map<Places, const TraverseEdge*> known;
  if (member.graphs.empty()) return known;
  for (const TraverseEdge& edge : member.graphs[window].edges) {
    known[PlacesOf(WayOf(member, window, edge))] = &edge;
  }
  return known;
}

}  // namespace

kg_base::LonLat BeginOf(const TeamMember& member, std::size_t window,
                        const TraverseEdge& edge) {
  if (window == 0) return member.rules.start;
  return member.graphs[window - 1].waypoints[edge.from].position;
}

EdgePrices::EdgePrices(const kg_selector::PlannedMission& now,
                       const CompiledPlan& then)
    : now_(now), prices_(now.members.size()) {
  std::vector<std::pair<std::size_t, std::size_t>> jobs;
  for (std::size_t i = 0; i < now.members.size(); ++i) {
    prices_[i].resize(now.members[i].graphs.size());
    for (std::size_t w = 0; w < prices_[i].size(); ++w) jobs.push_back({i, w});
  }
  kg_base::ForEachInParallel(jobs.size(), [&](std::size_t job) {
    const auto [i, w] = jobs[job];
    prices_[i][w] = PriceWindow(now.members[i], w, then);
  });
}

EdgePrices::WindowPrices EdgePrices::PriceWindow(
    const TeamMember& member, std::size_t window,
    const CompiledPlan& then) const {
  WindowPrices prices;
  const NavGraph& graph = member.graphs[window];
  prices.then.resize(graph.edges.size());
  const TeamMember* other = then.planned.FindMember(NameOf(member));
  if (other == nullptr) return prices;
  const auto place = PlaceOf(other->rules, graph.window);
  if (!place) return prices;
  prices.same =
      !other->graphs.empty() && other->graphs[*place].hash == graph.hash;
  if (prices.same) return prices;
  const auto known = KnownPrices(*other, *place);
  std::vector<WaypointRoute> ways;
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const WaypointRoute way = WayOf(member, window, graph.edges[i]);
    const auto found = known.find(PlacesOf(way));
    if (found != known.end()) {
      prices.then[i] = *found->second;
    } else {
      ways.push_back(way);
      unknown.push_back(i);
    }
  }
  if (ways.empty()) return prices;
  const auto worlds = kg_selector::FindWorlds(*then.compilation, other->rules);
  const kg_compiler::WindowTraversal sea(
      other->rules, other->rules.windows[*place], worlds[*place]);
  // If `other` has no graphs, use the alternatives of this graph.
  const NavGraph& places =
      other->graphs.empty() ? graph : other->graphs[*place];
  auto flown = kg_compiler::PriceWays(
      sea, ways, kg_compiler::PositionsOf(places.waypoints));
  for (std::size_t i = 0; i < ways.size(); ++i) {
    prices.then[unknown[i]] = std::move(flown[i]);
  }
  return prices;
}

const TraverseEdge* EdgePrices::Then(std::size_t member, std::size_t window,
                                     std::size_t edge) const {
  const WindowPrices& prices = prices_[member][window];
  if (prices.same) return &now_.members[member].graphs[window].edges[edge];
  return prices.then[edge] ? &*prices.then[edge] : nullptr;
}

}  // namespace kg_engine
