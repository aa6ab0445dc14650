#include "kg_compiler/control_plane/window_sea.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "kg_core/base/sha256.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

// Hazard is 0 farther than so many ranges from what is not open (it would be
// less than 0.0025), so that no flight depends on what lies farther.
constexpr double kHazardRanges = 6.0;
constexpr int kMargin_cells = 4;  // Moves, corners and bilinear squares.

// Hazard whose reach has an end.
kg_core::Raster BoundedHazard(const kg_core::Grid& grid,
                              const SeaSurface& surface, double range_m) {
  kg_core::Raster hazard =
      ComputeHazard(grid, surface.open, surface.attenuation, range_m);
  const float least = static_cast<float>(std::exp(-kHazardRanges));
  for (std::size_t i = 0; i < hazard.size(); ++i) {
    const double soft =
        std::clamp(1.0 - static_cast<double>(surface.attenuation[i]), 0.0, 1.0);
    if (hazard[i] < least) hazard[i] = static_cast<float>(soft);
  }
  return hazard;
}

// Cells that surely reach so far, at any row of a box.
struct CellsFor {
  int rows = 0;
  int cols = 0;
};
CellsFor CellsWithin(const kg_core::Grid& grid, double metres) {
  double row_m = std::numeric_limits<double>::infinity(), col_m = row_m;
  const std::vector<double>& lon = grid.lon_deg();
  const std::vector<double>& lat = grid.lat_deg();
  double least_lon_deg = row_m;
  for (std::size_t c = 1; c < lon.size(); ++c) {
    least_lon_deg = std::min(least_lon_deg, lon[c] - lon[c - 1]);
  }
  for (std::size_t r = 0; r < lat.size(); ++r) {
    const kg_core::DegreesPerMetre scale = kg_core::LocalScale(lat[r]);
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

}  // namespace

WindowSea::WindowSea(const SeamRules& rules, const WindowRules& window,
                     const WindowWorld& world)
    : rules_(rules),
      window_(window),
      grid_(world.tensor->grid),
      surface_(SurfaceOf(*world.tensor)),
      sea_{world.field, &surface_.open, nullptr} {}

bool WindowSea::IsOpen(kg_core::Cell cell) const {
  return surface_.open[grid_.Index(cell)];
}

Departure WindowSea::DepartureFrom(kg_core::LonLat source) const {
  return {source, window_.begin_s, window_.end_s, window_.base_travel_m};
}

const TraversalWorld& WindowSea::WithHazard() const {
  if (sea_.hazard == nullptr) {
    hazard_ = BoundedHazard(grid_, surface_, rules_.hazard_range_m);
    sea_.hazard = &hazard_;
  }
  return sea_;
}

double WindowSea::HoldableFrom_s(kg_core::LonLat place) const {
  return kg_compiler::HoldableFrom_s(sea_, rules_.motion, DepartureFrom(place),
                                     place);
}

Reach WindowSea::ReachFrom(kg_core::LonLat source) const {
  return ComputeReach(sea_, rules_.motion, DepartureFrom(source));
}

std::optional<Flight> WindowSea::Fly(kg_core::LonLat source, const Reach& reach,
                                     kg_core::LonLat to) const {
  return Traverse(WithHazard(), rules_.motion, DepartureFrom(source), reach,
                  to);
}

std::string WindowSea::Terms() const {
  const MotionModel& motion = rules_.motion;
  const SeamWeights& weights = rules_.weights;
  kg_core::Hasher hash;
  for (const double value :
       {motion.cruise_mps, motion.max_mps, motion.boost_gain,
        motion.energy_per_m_j, motion.hotel_load_w, weights.time_per_s,
        weights.energy_per_j, weights.risk_per_s, rules_.hazard_range_m,
        window_.begin_s, window_.end_s, window_.base_travel_m}) {
    hash.Add(value);
  }
  hash.Add(window_.field_hash);
  hash.Add(static_cast<double>(grid_.rows()));
  hash.Add(static_cast<double>(grid_.cols()));
  return hash.Hex();
}

CellBox WindowSea::ReadBox(kg_core::LonLat source, const Reach& reach) const {
  const std::optional<kg_core::Cell> cell = grid_.CellAt(source);
  if (!cell) return {};
  CellBox box{cell->row, cell->row + 1, cell->col, cell->col + 1};
  for (const ReachedCell& reached : reach.cells) {
    const int row = reached.index / grid_.cols();
    const int col = reached.index % grid_.cols();
    box = Join(box, {row, row + 1, col, col + 1});
  }
  // A flight goes nowhere faster than the agent and the strongest current.
  const double speed_mps =
      rules_.motion.cruise_mps +
      std::abs(rules_.motion.boost_gain) * sea_.field->MaxSpeed_mps();
  const CellsFor far =
      CellsWithin(grid_, speed_mps * (window_.end_s - window_.begin_s));
  const CellBox flown =
      Grow({cell->row, cell->row + 1, cell->col, cell->col + 1}, far.rows,
           far.cols, grid_);
  return Grow(Join(box, flown), kMargin_cells, kMargin_cells, grid_);
}

CellBox WindowSea::HazardBox(const CellBox& read) const {
  const CellsFor far =
      CellsWithin(grid_, kHazardRanges * rules_.hazard_range_m);
  return Grow(read, far.rows, far.cols, grid_);
}

double WindowSea::Isolation(
    kg_core::LonLat place,
    const std::vector<kg_core::LonLat>& waypoints) const {
  const double near_m = 0.5 * window_.base_travel_m;
  int others = 0;
  for (const kg_core::LonLat& waypoint : waypoints) {
    others +=
        waypoint != place && kg_core::Distance_m(place, waypoint) <= near_m;
  }
  return rules_.weights.isolation / (1.0 + others);
}

TraverseEdge WindowSea::Price(Flight flight, double isolation) const {
  TraverseEdge edge;
  edge.isolation_s = isolation * flight.travel_s;
  edge.flight = std::move(flight);
  edge.seam_cost = SeamCost(rules_.weights, edge, window_.confidence);
  return edge;
}

std::vector<std::optional<TraverseEdge>> PriceWays(
    const WindowSea& sea, const std::vector<Way>& ways,
    const std::vector<kg_core::LonLat>& waypoints) {
  std::map<std::pair<double, double>, Reach> reaches;  // By source.
  std::vector<std::optional<TraverseEdge>> prices;
  for (const Way& way : ways) {
    const std::pair<double, double> key(way.from.lon_deg, way.from.lat_deg);
    auto reach = reaches.find(key);
    if (reach == reaches.end()) {
      reach = reaches.emplace(key, sea.ReachFrom(way.from)).first;
    }
    std::optional<Flight> flight = sea.Fly(way.from, reach->second, way.to);
    prices.emplace_back();
    if (!flight) continue;
    prices.back() =
        sea.Price(std::move(*flight), sea.Isolation(way.to, waypoints));
  }
  return prices;
}

std::vector<kg_core::LonLat> PositionsOf(
    const std::vector<Waypoint>& waypoints) {
  std::vector<kg_core::LonLat> positions;
  for (const Waypoint& waypoint : waypoints) {
    positions.push_back(waypoint.position);
  }
  return positions;
}

}  // namespace kg_compiler
