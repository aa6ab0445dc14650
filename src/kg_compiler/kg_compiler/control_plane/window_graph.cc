#include "kg_compiler/control_plane/window_graph.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "kg_base/common/sha256.h"
#include "kg_base/geo/geodesy.h"
#include "kg_compiler/control_plane/cropped_recurrence.h"
#include "kg_compiler/control_plane/proximal_recurrence.h"
#include "kg_compiler/control_plane/window_traversal.h"

namespace kg_compiler {
namespace {

constexpr int kFewWaypoints = 3;  // With fewer, staying in place is offered.
constexpr int kPicksPerWaypoint = 2;  // Some picks cannot be flown to.

// A candidate waypoint with the flights to it.
struct WaypointDraft {
  Waypoint waypoint;
  kg_base::Cell cell;
  // (source index, flight).
  std::vector<std::pair<int, std::shared_ptr<const FlownPath>>> flights;
};

class GraphBuilder {
 public:
  GraphBuilder(const WindowInputs& inputs, const KeptSeams* last,
               SeamCounts* counts)
      : in_(inputs),
        grid_(inputs.world.tensor->grid),
        fused_(inputs.world.tensor->Get(Layer::kFused)),
        traversal_(*inputs.rules, *inputs.window, inputs.world),
        seams_(traversal_, inputs.world.tensor->hash, last, counts) {}

  BuiltWindow Build() {
    if (in_.window->committed) Add(*in_.window->committed);
    AddEvents();
    AddPicks();
    if (static_cast<int>(drafts_.size()) < kFewWaypoints) AddStays();
    NavGraph graph = Finish();
    return {std::move(graph), seams_.Keep()};
  }

 private:
  // Adds the place if it can be flown to from at least one source.
  bool Add(kg_base::LonLat position) {
    const std::optional<kg_base::Cell> cell = grid_.CellAt(position);
    if (!cell || !traversal_.IsOpen(*cell)) return false;
    WaypointDraft draft;
    draft.cell = *cell;
    draft.waypoint.position = position;
    for (std::size_t i = 0; i < in_.sources.size(); ++i) {
      auto flight = seams_.Fly(in_.sources[i], position);
      if (flight) draft.flights.emplace_back(i, std::move(flight));
    }
    if (draft.flights.empty()) return false;
    drafts_.push_back(std::move(draft));
    return true;
  }

  bool Taken(kg_base::LonLat position) const {
    return std::any_of(drafts_.begin(), drafts_.end(),
                       [&](const WaypointDraft& draft) {
                         return draft.waypoint.position == position;
                       });
  }
  bool TakenCell(kg_base::Cell cell) const {
    return std::any_of(
        drafts_.begin(), drafts_.end(),
        [&](const WaypointDraft& draft) { return draft.cell == cell; });
  }
  // Is the cell the committed end of the current plan, which is the first
  // draft?
  bool IsCommitted(kg_base::Cell cell) const {
    return in_.window->committed && !drafts_.empty() &&
           drafts_.front().waypoint.position == *in_.window->committed &&
           drafts_.front().cell == cell &&
           grid_.Centre(cell) == *in_.window->committed;
  }
  static void Score(const RecurrencePick& pick, WaypointDraft* draft) {
    draft->waypoint.score = pick.score;
    draft->waypoint.footprint = pick.footprint;
  }
  bool Full() const {
    return static_cast<int>(drafts_.size()) >= in_.rules->max_waypoints;
  }

  // Events with the highest reward first, so that the limit drops the others.
  void AddEvents() {
    std::vector<EventRule> events = in_.window->events;
    std::stable_sort(events.begin(), events.end(),
                     [](const EventRule& a, const EventRule& b) {
                       return a.reward > b.reward;
                     });
    for (const EventRule& event : events) {
      if (!Full() && !Taken(event.position)) Add(event.position);
    }
  }

  // Cells reachable from some source at which station can be held from arrival
  // on.
  std::vector<int> Allowed() {
    std::vector<int> allowed;
    for (const kg_base::LonLat& source : in_.sources) {
      const std::vector<int>& landings = seams_.Landings(source);
      allowed.insert(allowed.end(), landings.begin(), landings.end());
    }
    std::sort(allowed.begin(), allowed.end());
    allowed.erase(std::unique(allowed.begin(), allowed.end()), allowed.end());
    return allowed;
  }

  void AddPicks() {
    if (Full()) return;
    RecurrenceOptions options;
    options.radius_m = in_.rules->sensor_radius_m;
    options.spacing_m = in_.rules->spacing_m > 0.0 ? in_.rules->spacing_m
                                                   : in_.rules->sensor_radius_m;
    options.count = kPicksPerWaypoint * in_.rules->max_waypoints;
    for (const RecurrencePick& pick :
         RecurrenceWithin(grid_, fused_, Allowed(), options, seams_.picks())) {
      if (IsCommitted(pick.cell)) {
        Score(pick, &drafts_.front());
        continue;
      }
      if (Full()) return;
      if (TakenCell(pick.cell) || !Add(grid_.Centre(pick.cell))) continue;
      Score(pick, &drafts_.back());
    }
  }

  void AddStays() {
    for (const kg_base::LonLat& source : in_.sources) {
      if (Full()) return;
      if (!Taken(source)) Add(source);
    }
  }

  void Describe(WaypointDraft* draft) const {
    Waypoint& waypoint = draft->waypoint;
    waypoint.value = fused_[grid_.Index(draft->cell)];
    if (waypoint.score == 0.0) {
      RecurrencePick pick =
          DiscSum(grid_, fused_, draft->cell, in_.rules->sensor_radius_m);
      waypoint.score = pick.score;
      waypoint.footprint = std::move(pick.footprint);
    }
    for (const EventRule& event : in_.window->events) {
      const double away_m =
          kg_base::Distance_m(event.position, waypoint.position);
      if (!(away_m <= event.radius_m)) continue;
      waypoint.events.push_back(event.iri);
      waypoint.event_reward += event.reward;
    }
  }

  void Order() {
    for (WaypointDraft& draft : drafts_) Describe(&draft);
    std::stable_sort(
        drafts_.begin(), drafts_.end(),
        [](const WaypointDraft& a, const WaypointDraft& b) {
          return std::tie(b.waypoint.score, a.cell.row, a.cell.col) <
                 std::tie(a.waypoint.score, b.cell.row, b.cell.col);
        });
  }

  NavGraph Finish() {
    Order();
    NavGraph graph;
    graph.agent_iri = in_.rules->agent_iri;
    graph.window = in_.window->window;
    graph.movement_mode = in_.rules->movement_mode;
    graph.hash = WindowGraphHash(in_);
    for (WaypointDraft& draft : drafts_) {
      draft.waypoint.id = static_cast<int>(graph.waypoints.size());
      graph.waypoints.push_back(std::move(draft.waypoint));
    }
    // Isolation depends on all waypoints, so edges are priced last.
    const std::vector<double> isolation = Isolation(graph.waypoints);
    for (std::size_t to = 0; to < drafts_.size(); ++to) {
      for (const auto& [from, flight] : drafts_[to].flights) {
        graph.edges.push_back(traversal_.PriceEntry(*flight, isolation[to]));
        graph.edges.back().from = from;
        graph.edges.back().to = static_cast<int>(to);
      }
    }
    SortByEnds(&graph.edges);
    if (graph.movement_mode == MovementMode::kEdges) {
      AddInnerEdges(isolation, &graph);
    }
    return graph;
  }

  std::vector<double> Isolation(const std::vector<Waypoint>& waypoints) const {
    const std::vector<kg_base::LonLat> places = PositionsOf(waypoints);
    std::vector<double> isolation;
    for (const kg_base::LonLat& place : places) {
      isolation.push_back(traversal_.Isolation(place, places));
    }
    return isolation;
  }

  // Ids of the other waypoints, nearest first.
  static std::vector<int> Others(const std::vector<Waypoint>& waypoints,
                                 int from) {
    std::vector<std::pair<double, int>> others;
    for (const Waypoint& waypoint : waypoints) {
      if (waypoint.id == from) continue;
      others.emplace_back(
          kg_base::Distance_m(waypoints[from].position, waypoint.position),
          waypoint.id);
    }
    std::sort(others.begin(), others.end());
    std::vector<int> ids;
    for (const auto& [distance_m, id] : others) ids.push_back(id);
    return ids;
  }

  void AddInnerEdges(const std::vector<double>& isolation, NavGraph* graph) {
    for (const Waypoint& from : graph->waypoints) {
      int found = 0;
      for (const int to : Others(graph->waypoints, from.id)) {
        const auto flight =
            seams_.Fly(from.position, graph->waypoints[to].position);
        if (!flight) continue;
        graph->inner_edges.push_back(
            traversal_.PriceInner(*flight, isolation[to]));
        graph->inner_edges.back().from = from.id;
        graph->inner_edges.back().to = to;
        if (++found == kInnerNeighbours) break;
      }
    }
    SortByEnds(&graph->inner_edges);
  }

  static void SortByEnds(std::vector<TraverseEdge>* edges) {
    std::sort(edges->begin(), edges->end(),
              [](const TraverseEdge& a, const TraverseEdge& b) {
                return std::tie(a.from, a.to) < std::tie(b.from, b.to);
              });
  }

  const WindowInputs& in_;
  const kg_base::Grid& grid_;
  const kg_base::Raster fused_;
  WindowTraversal traversal_;
  SeamFlyer seams_;
  std::vector<WaypointDraft> drafts_;
};

void HashRules(const SeamRules& rules, kg_base::Hasher* hash) {
  hash->Add(rules.agent_iri);
  HashMotion(rules.motion, hash);
  HashWeights(rules.weights, hash);
  for (const double value :
       {rules.sensor_radius_m, rules.spacing_m, rules.hazard_range_m,
        static_cast<double>(rules.max_waypoints)}) {
    hash->Add(value);
  }
  hash->Add(Name(rules.movement_mode));
}

void HashGraphWindow(const WindowRules& window, kg_base::Hasher* hash) {
  for (const double value :
       {static_cast<double>(window.window), window.begin_s, window.end_s,
        window.confidence, window.base_travel_m,
        static_cast<double>(window.events.size())}) {
    hash->Add(value);
  }
  for (const EventRule& event : window.events) {
    hash->Add(event.iri);
    hash->Add(event.position.lon_deg);
    hash->Add(event.position.lat_deg);
    hash->Add(event.reward);
    hash->Add(event.radius_m);
  }
  HashCommitted(window, hash);
}

}  // namespace

std::string WindowGraphHash(const WindowInputs& inputs) {
  kg_base::Hasher hash;
  HashRules(*inputs.rules, &hash);
  HashGraphWindow(*inputs.window, &hash);
  HashStartHeading(*inputs.rules, *inputs.window, &hash);
  hash.Add(inputs.world.tensor->hash);
  hash.Add(inputs.window->field_hash.empty() ? inputs.world.field->Hash()
                                             : inputs.window->field_hash);
  for (const kg_base::LonLat& source : inputs.sources) {
    hash.Add(source.lon_deg);
    hash.Add(source.lat_deg);
  }
  return hash.Hex();
}

BuiltWindow BuildWindowGraph(const WindowInputs& inputs, const KeptSeams* last,
                             SeamCounts* counts) {
  return GraphBuilder(inputs, last, counts).Build();
}

bool IsOpenAt(const MissionTensor& tensor, kg_base::LonLat position) {
  const std::optional<kg_base::Cell> cell = tensor.grid.CellAt(position);
  if (!cell) return false;
  return tensor.At(Layer::kFeasibility, tensor.grid.Index(*cell)) == 1.0f;
}

}  // namespace kg_compiler
