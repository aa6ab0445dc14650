#include "kg_compiler/control_plane/window_traversal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "kg_base/common/sha256.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"
#include "kg_compiler/control_plane/field_exposure.h"
#include "kg_compiler/control_plane/seam_cost.h"

namespace kg_compiler {
namespace {

// Numbers of cells that certainly cover a distance in any row of a box.
struct CellsFor {
  int rows = 0;
  int cols = 0;
};
CellsFor CellsWithin(const kg_base::Grid& grid, double metres) {
  double row_m = std::numeric_limits<double>::infinity(), col_m = row_m;
  const std::vector<double>& lon = grid.lon_deg();
  const std::vector<double>& lat = grid.lat_deg();
  // Smallest cell of the grid in metres along either axis. The height of a row
  // [m/deg] varies with latitude by less than 1 %.
  double least_lon_deg = row_m;
  for (std::size_t c = 1; c < lon.size(); ++c) {
    least_lon_deg = std::min(least_lon_deg, lon[c] - lon[c - 1]);
  }
  for (std::size_t r = 0; r < lat.size(); ++r) {
    const kg_base::DegreesPerMetre scale = kg_base::LocalScale(lat[r]);
    col_m = std::min(col_m, least_lon_deg / scale.lon_deg);
    if (r > 0) {
      row_m = std::min(row_m, 0.99 * (lat[r] - lat[r - 1]) / scale.lat_deg);
    }
  }
  const auto cells = [&](double cell_m) {
    const double wanted = std::ceil(metres / cell_m) + 1.0;
    return static_cast<int>(
        std::min<double>(wanted, grid.rows() + grid.cols()));
  };
  return {cells(row_m), cells(col_m)};
}

// Turning points of a flight, without repeated positions.
std::vector<kg_base::LonLat> TrackOf(const FlownPath& flight) {
  std::vector<kg_base::LonLat> track;
  for (const TimedPoint& point : flight.track) {
    if (track.empty() || track.back() != point.position) {
      track.push_back(point.position);
    }
  }
  return track;
}

// Course over ground on which a flight leaves, rad clockwise from north; legs
// are straight in longitude and latitude. Nullopt if it stays.
std::optional<double> LeavingCourse_rad(const FlownPath& flight) {
  const std::vector<kg_base::LonLat> track = TrackOf(flight);
  if (track.size() < 2) return std::nullopt;
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(track[0].lat_deg);
  return std::atan2((track[1].lon_deg - track[0].lon_deg) / scale.lon_deg,
                    (track[1].lat_deg - track[0].lat_deg) / scale.lat_deg);
}

// Flies between places within one window, caching the arrival fields.
class RouteFlyer {
 public:
  explicit RouteFlyer(const WindowTraversal& traversal)
      : traversal_(traversal) {}

  std::optional<FlownPath> Fly(kg_base::LonLat from, kg_base::LonLat to) {
    const std::pair<double, double> key(from.lon_deg, from.lat_deg);
    auto reach = reaches_.find(key);
    if (reach == reaches_.end()) {
      reach = reaches_.emplace(key, traversal_.ReachFrom(from)).first;
    }
    return traversal_.Fly(from, reach->second, to);
  }

  std::optional<TraverseEdge> FlyBy(const WaypointRoute& way,
                                    double isolation) {
    std::vector<FlownPath> flights;
    kg_base::LonLat at = way.from;
    std::vector<kg_base::LonLat> stops = way.via;
    stops.push_back(way.to);
    for (const kg_base::LonLat stop : stops) {
      std::optional<FlownPath> flight = Fly(at, stop);
      if (!flight) return std::nullopt;
      flights.push_back(std::move(*flight));
      at = stop;
    }
    if (flights.size() == 1) {
      return traversal_.PriceEntry(std::move(flights.front()), isolation);
    }
    std::vector<const FlownPath*> legs;
    for (const FlownPath& flight : flights) legs.push_back(&flight);
    return traversal_.FlyWalk(way.from, legs, isolation);
  }

 private:
  const WindowTraversal& traversal_;
  // Arrival field per source (lon, lat) [deg].
  std::map<std::pair<double, double>, ReachMap> reaches_;
};

}  // namespace

WindowTraversal::WindowTraversal(const SeamRules& rules,
                                 const WindowRules& window,
                                 const WindowWorld& world)
    : rules_(rules),
      window_(window),
      grid_(world.tensor->grid),
      surface_(SurfaceOf(*world.tensor)),
      hazard_(grid_, surface_.open, surface_.attenuation, rules.hazard_range_m),
      field_(*world.field) {}

bool WindowTraversal::IsOpen(kg_base::Cell cell) const {
  return surface_.open[grid_.Index(cell)];
}

VoyageRequest WindowTraversal::VoyageFrom(kg_base::LonLat source) const {
  const SeamWeights& weights = rules_.weights;
  return {{&field_, &surface_.open, &hazard_},
          rules_.motion,
          {source, window_.begin_s, window_.end_s, window_.base_travel_m},
          {weights.time_per_s, weights.energy_per_j, weights.risk_per_s}};
}

double WindowTraversal::HoldableFrom_s(kg_base::LonLat place) const {
  return kg_compiler::HoldableFrom_s(VoyageFrom(place), place);
}

ReachMap WindowTraversal::ReachFrom(kg_base::LonLat source) const {
  return ComputeReach(VoyageFrom(source));
}

std::optional<FlownPath> WindowTraversal::Fly(kg_base::LonLat source,
                                              const ReachMap& reach,
                                              kg_base::LonLat to) const {
  return Traverse(VoyageFrom(source), reach, to);
}

std::optional<TraverseEdge> WindowTraversal::FlyWalk(
    kg_base::LonLat source, const std::vector<const FlownPath*>& legs,
    double isolation) const {
  std::vector<TrackStretch> stretches;
  bool slow = false;
  for (const FlownPath* leg : legs) {
    stretches.push_back({TrackOf(*leg), leg->speed_mps});
    slow = slow || leg->speed_mps != rules_.motion.cruise_mps;
  }
  const VoyageRequest voyage = VoyageFrom(source);
  std::optional<FlownPath> flight = FlyStretches(voyage, stretches);
  // A walk at slower speeds may arrive too late: retry at cruise speed.
  if (!flight && slow) {
    for (TrackStretch& stretch : stretches) {
      stretch.speed_mps = rules_.motion.cruise_mps;
    }
    flight = FlyStretches(voyage, stretches);
  }
  if (!flight) return std::nullopt;
  return PriceEntry(std::move(*flight), isolation);
}

double WindowTraversal::HazardAt(kg_base::LonLat place) const {
  const std::optional<kg_base::Cell> cell = grid_.CellAt(place);
  return cell ? hazard_.At(*cell) : 0.0;
}

std::string WindowTraversal::Terms() const {
  const SeamWeights& weights = rules_.weights;
  kg_base::Hasher hash;
  HashMotion(rules_.motion, &hash);
  for (const double value :
       {weights.time_per_s, weights.energy_per_j, weights.risk_per_s,
        rules_.hazard_range_m, window_.begin_s, window_.end_s,
        window_.base_travel_m}) {
    hash.Add(value);
  }
  hash.Add(window_.field_hash);
  hash.Add(static_cast<double>(grid_.rows()));
  hash.Add(static_cast<double>(grid_.cols()));
  return hash.Hex();
}

CellBox WindowTraversal::HazardBox(const CellBox& read) const {
  const CellsFor far =
      CellsWithin(grid_, HazardMap::kRanges * rules_.hazard_range_m);
  return Grown(read, far.rows, far.cols, grid_);
}

double WindowTraversal::Isolation(
    kg_base::LonLat place,
    const std::vector<kg_base::LonLat>& waypoints) const {
  const double near_m = 0.5 * window_.base_travel_m;
  int others = 0;
  for (const kg_base::LonLat& waypoint : waypoints) {
    others +=
        waypoint != place && kg_base::Distance_m(place, waypoint) <= near_m;
  }
  return rules_.weights.isolation / (1.0 + others);
}

TraverseEdge WindowTraversal::PriceEntry(FlownPath flight,
                                         double isolation) const {
  double turn_rad = 0.0;
  if (ChargesTurns(rules_, window_)) {
    const std::optional<double> course_rad = LeavingCourse_rad(flight);
    if (course_rad) {
      turn_rad = std::abs(std::remainder(*course_rad - rules_.start_heading_rad,
                                         2.0 * kg_base::kPi));
    }
  }
  return Price(std::move(flight), isolation, turn_rad);
}

TraverseEdge WindowTraversal::PriceInner(FlownPath flight,
                                         double isolation) const {
  return Price(std::move(flight), isolation, 0.0);
}

TraverseEdge WindowTraversal::Price(FlownPath flight, double isolation,
                                    double turn_rad) const {
  TraverseEdge edge;
  edge.turn_rad = turn_rad;
  edge.isolation_s = isolation * flight.travel_s;
  edge.exposures = FieldExposures(field_, flight);
  edge.flight = std::move(flight);
  edge.seam_cost = SeamCost(rules_.weights, edge, window_.confidence);
  return edge;
}

std::vector<std::optional<TraverseEdge>> PriceWays(
    const WindowTraversal& traversal, const std::vector<WaypointRoute>& ways,
    const std::vector<kg_base::LonLat>& waypoints) {
  RouteFlyer flyer(traversal);
  std::vector<std::optional<TraverseEdge>> prices;
  for (const WaypointRoute& way : ways) {
    prices.push_back(flyer.FlyBy(way, traversal.Isolation(way.to, waypoints)));
  }
  return prices;
}

}  // namespace kg_compiler
