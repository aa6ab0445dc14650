#include "kg_compiler/control_plane/window_sea.h"

#include <map>
#include <utility>

namespace kg_compiler {
namespace {

kg_core::Mask OpenCells(const MissionTensor& tensor) {
  const kg_core::Raster feasibility = tensor.Get(Layer::kFeasibility);
  kg_core::Mask open(feasibility.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = feasibility[i] == 1.f;
  return open;
}

}  // namespace

WindowSea::WindowSea(const SeamRules& rules, const WindowRules& window,
                     const WindowWorld& world)
    : rules_(rules),
      window_(window),
      grid_(world.tensor->grid),
      open_(OpenCells(*world.tensor)),
      hazard_(grid_, open_, world.tensor->Get(Layer::kAttenuation),
              rules.hazard_range_m),
      field_(*world.field) {}

bool WindowSea::IsOpen(kg_core::Cell cell) const {
  return open_[grid_.Index(cell)];
}

Voyage WindowSea::VoyageFrom(kg_core::LonLat source) const {
  const SeamWeights& weights = rules_.weights;
  return {{&field_, &open_, &hazard_},
          rules_.motion,
          {source, window_.begin_s, window_.end_s, window_.base_travel_m},
          {weights.time_per_s, weights.energy_per_j, weights.risk_per_s}};
}

double WindowSea::HoldableFrom_s(kg_core::LonLat place) const {
  return kg_compiler::HoldableFrom_s(VoyageFrom(place), place);
}

Reach WindowSea::ReachFrom(kg_core::LonLat source) const {
  return ComputeReach(VoyageFrom(source));
}

std::optional<TraverseEdge> WindowSea::Fly(kg_core::LonLat source,
                                           const Reach& reach,
                                           kg_core::LonLat to) const {
  std::optional<Flight> flight = Traverse(VoyageFrom(source), reach, to);
  if (!flight) return std::nullopt;
  const double cost = SeamCost(rules_.weights, *flight, window_.confidence);
  return TraverseEdge{0, 0, std::move(*flight), cost};
}

std::vector<std::optional<TraverseEdge>> PriceWays(
    const WindowSea& sea, const std::vector<Way>& ways) {
  std::map<std::pair<double, double>, Reach> reaches;  // By source.
  std::vector<std::optional<TraverseEdge>> prices;
  for (const Way& way : ways) {
    const std::pair<double, double> key(way.from.lon_deg, way.from.lat_deg);
    auto reach = reaches.find(key);
    if (reach == reaches.end()) {
      reach = reaches.emplace(key, sea.ReachFrom(way.from)).first;
    }
    prices.push_back(sea.Fly(way.from, reach->second, way.to));
  }
  return prices;
}

}  // namespace kg_compiler
