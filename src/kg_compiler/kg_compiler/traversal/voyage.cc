#include "kg_compiler/traversal/voyage.h"

#include <cmath>

namespace kg_compiler {
namespace {

constexpr double kLongest_s = 100.0 * 366.0 * 86400.0;

bool IsWellFormed(const TraversalWorld& world) {
  if (world.field == nullptr || world.open == nullptr) return false;
  const std::size_t size = world.field->grid.size();
  for (const kg_base::FieldSlice& slice : world.field->slices) {
    if (slice.east_mps.size() != size || slice.north_mps.size() != size) {
      return false;
    }
  }
  return size > 0 && !world.field->slices.empty() && world.open->size() == size;
}

bool IsWellFormed(const MotionModel& motion) {
  return motion.cruise_mps >= 0.0 && !std::isnan(motion.max_mps) &&
         std::isfinite(motion.cruise_mps) && std::isfinite(motion.boost_gain) &&
         std::isfinite(motion.energy_per_m_j) &&
         std::isfinite(motion.hotel_load_w) && std::isfinite(motion.rest_mps);
}

bool IsWellFormed(const VoyageDeparture& departure) {
  const double whole_s = departure.deadline_s - departure.time_s;
  return std::isfinite(departure.from.lon_deg) &&
         std::isfinite(departure.from.lat_deg) &&
         std::isfinite(departure.time_s) && whole_s >= 0.0 &&
         whole_s <= kLongest_s && !std::isnan(departure.base_travel_m);
}

}  // namespace

bool IsWellFormed(const VoyageRequest& voyage) {
  const FlightPrice& price = voyage.price;
  return IsWellFormed(voyage.world) && IsWellFormed(voyage.motion) &&
         IsWellFormed(voyage.departure) &&
         !std::isnan(price.per_s + price.per_j + price.per_hazard_s);
}

}  // namespace kg_compiler
