// Traverse: selects the speed through water by the cost of the flight.

#include "kg_compiler/traversal/traversal.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/units.h"
#include "kg_compiler/traversal/crossing.h"
#include "kg_compiler/traversal/leg.h"
#include "kg_compiler/traversal/sight.h"
#include "kg_compiler/traversal/slower_reaches.h"

namespace kg_compiler {
namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr int kRefinements = 10;
using kg_base::kInfinity;
constexpr int kNear_cells = 2;
constexpr double kHoldStep_s = 1800.0;
constexpr double kWorth = 1e-3;  // Least relative cost reduction worth trying.
constexpr double kSure = 0.9;    // Safety factor for currents between samples.

// Lower bound of the arrival at a place: the earliest arrival in the
// surrounding cells. Infinite if no cell within kNear_cells is reached.
double Earliest_s(const ReachMap& reach, const kg_base::Grid& grid,
                  kg_base::Cell place) {
  for (int around = 1; around <= kNear_cells; ++around) {
    double earliest_s = kInfinity;
    for (int dr = -around; dr <= around; ++dr) {
      for (int dc = -around; dc <= around; ++dc) {
        const kg_base::Cell cell{place.row + dr, place.col + dc};
        if (!grid.Contains(cell)) continue;
        const ReachedCell* found =
            reach.Find(static_cast<int>(grid.Index(cell)));
        if (found) earliest_s = std::min(earliest_s, found->arrival_s);
      }
    }
    if (earliest_s < kInfinity) return earliest_s;
  }
  return kInfinity;
}

// A candidate speed as a fraction of the full speed, with its flight and cost.
struct SpeedChoice {
  double share = 1.0;
  double cost = kInfinity;
  std::optional<FlownPath> flight;
};

class SpeedSearch {
 public:
  SpeedSearch(const VoyageRequest& voyage, const ReachMap& reach,
              kg_base::LonLat to, kg_base::GridPoint at)
      : voyage_(voyage), reach_(reach), to_(to), at_(at) {
    const VoyageDeparture& departure = voyage.departure;
    const LegFlyer flyer(voyage);
    whole_s_ = departure.deadline_s - departure.time_s;
    const int steps = static_cast<int>(std::ceil(whole_s_ / kHoldStep_s));
    for (int i = 0; i <= steps; ++i) {
      const auto c = flyer.Current(at, whole_s_ * i / steps);
      current_mps_.push_back(c ? std::hypot(c->east_mps, c->north_mps) : 0.0);
    }
  }

  std::optional<FlownPath> Cheapest() const {
    SpeedChoice best = Try(1.0, reach_);
    // From fast to slow: the lower bound on the arrival can only grow.
    double earliest_s = NotBefore(EarliestBy(reach_), best);
    int chosen = -1;
    bool between = false;  // May the optimum lie next to the fastest?
    for (int k = 0; k < SlowerReaches::kCount; ++k) {
      const double share = SlowerReaches::kShares[k];
      if (!IsWorthIt(share, earliest_s, best)) continue;
      const ReachMap* reach = reach_.slower->At(k, voyage_, reach_.read);
      SpeedChoice slower;
      if (reach) {
        earliest_s = std::max(earliest_s, EarliestBy(*reach));
        if (IsWorthIt(share, earliest_s, best)) slower = Try(share, *reach);
        earliest_s = NotBefore(earliest_s, slower);
      }
      if (k == 0) between = !slower.flight && best.flight;
      if (!(slower.cost < best.cost)) continue;
      best = std::move(slower);
      chosen = k;
    }
    if (chosen >= 0 || between) best = Refined(std::move(best), chosen);
    return std::move(best.flight);
  }

 private:
  double EarliestBy(const ReachMap& reach) const {
    const kg_base::Grid& grid = voyage_.world.field->grid;
    return Earliest_s(reach, grid, CellOf(grid, at_));
  }
  // Lower bound of the cost of any flight at a speed v that arrives at
  // `earliest_s` or later: each second until the deadline is charged either
  // with v or with the speed |c| of the current to hold against.
  double LeastCost(double share, double earliest_s) const {
    if (!(earliest_s <= whole_s_)) return kInfinity;
    const double own_mps = share * voyage_.motion.cruise_mps;
    const double steps = static_cast<double>(current_mps_.size() - 1);
    double held_m = 0.0;
    for (std::size_t i = 0; i < current_mps_.size(); ++i) {
      const double time_s = whole_s_ * static_cast<double>(i) / steps;
      if (time_s < earliest_s + kHoldStep_s) continue;
      held_m += std::min(own_mps, current_mps_[i]) * whole_s_ / steps;
    }
    const MotionModel& motion = voyage_.motion;
    const double through_m = own_mps * earliest_s + kSure * held_m;
    return voyage_.price.per_s * earliest_s +
           voyage_.price.per_j * (motion.energy_per_m_j * through_m +
                                  motion.hotel_load_w * whole_s_);
  }
  bool IsWorthIt(double share, double earliest_s,
                 const SpeedChoice& best) const {
    const double anyway =
        voyage_.price.per_j * voyage_.motion.hotel_load_w * whole_s_;
    const double least = LeastCost(share, earliest_s);
    return least < kInfinity &&
           (!best.flight || least < best.cost - kWorth * (best.cost - anyway));
  }
  // A slower flight cannot arrive before a faster one.
  static double NotBefore(double earliest_s, const SpeedChoice& faster) {
    return faster.flight ? std::max(earliest_s, faster.flight->travel_s)
                         : earliest_s;
  }
  VoyageRequest At(double share) const {
    VoyageRequest voyage = voyage_;
    voyage.motion.cruise_mps *= share;
    return voyage;
  }
  SpeedChoice Try(double share, const ReachMap& reach,
                  bool is_its_own = true) const {
    const VoyageRequest voyage = At(share);
    SpeedChoice choice;
    choice.share = share;
    const FastestCrossing crossing(voyage, reach, to_, at_);
    choice.flight = is_its_own ? crossing.Fastest() : crossing.First();
    if (choice.flight) {
      const FlightPrice& price = voyage_.price;
      choice.cost = price.per_s * choice.flight->travel_s +
                    price.per_j * choice.flight->energy_j +
                    price.per_hazard_s * choice.flight->hazard_s;
    }
    return choice;
  }
  // Golden-section search between the two speeds adjacent to the chosen one,
  // which has the least cost of the three; infeasible speeds cost infinity.
  SpeedChoice Refined(SpeedChoice best, int chosen) const {
    const int last = SlowerReaches::kCount - 1;
    double low = chosen == last ? 0.0 : SlowerReaches::kShares[chosen + 1];
    const double fastest_s = EarliestBy(reach_);
    const ReachMap& reach =
        chosen < 0 ? reach_ : *reach_.slower->At(chosen, voyage_, reach_.read);
    double high = chosen <= 0 ? 1.0 : SlowerReaches::kShares[chosen - 1];
    for (int i = 0; i < kRefinements; ++i) {
      // Probe the longer of the two intervals; the best stays bracketed by low
      // and high.
      const bool up = high - best.share > best.share - low;
      const double share =
          up ? best.share + (1.0 - kGolden) * (high - best.share)
             : best.share - (1.0 - kGolden) * (best.share - low);
      if (!IsWorthIt(low, fastest_s, best)) break;
      SpeedChoice next = Try(share, reach, false);
      const bool better = next.cost < best.cost;
      (up == better ? low : high) = better ? best.share : share;
      if (better) best = std::move(next);
    }
    return best;
  }

  const VoyageRequest& voyage_;
  const ReachMap& reach_;
  kg_base::LonLat to_;
  kg_base::GridPoint at_;
  double whole_s_;
  std::vector<double> current_mps_;  // |c| at the place, in equal time steps.
};

}  // namespace

std::optional<FlownPath> Traverse(const VoyageRequest& voyage,
                                  const ReachMap& reach, kg_base::LonLat to) {
  if (!IsWellFormed(voyage)) return std::nullopt;
  const auto at = voyage.world.field->grid.Locate(to);
  if (!at) return std::nullopt;
  if (!(voyage.price.per_j > 0.0) || !reach.slower) {
    return FastestCrossing(voyage, reach, to, *at).Fastest();
  }
  return SpeedSearch(voyage, reach, to, *at).Cheapest();
}

}  // namespace kg_compiler
