// Traverse: the price decides how fast to go.

#include "kg_compiler/traversal/traversal.h"

#include <cmath>
#include <limits>

#include "kg_compiler/traversal/crossing.h"
#include "kg_compiler/traversal/slower_reaches.h"

namespace kg_compiler {
namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr int kRefinements = 10;

// Shares of the full speed: those tried, with their reaches, fastest first.
struct Choice {
  double share = 1.0;
  double cost = std::numeric_limits<double>::infinity();
  std::optional<Flight> flight;
};

class Pricing {
 public:
  Pricing(const Voyage& voyage, const Reach& reach, kg_core::LonLat to,
          kg_core::GridPoint at)
      : voyage_(voyage), reach_(reach), to_(to), at_(at) {}

  std::optional<Flight> Cheapest() const {
    Choice best = Try(1.0, reach_);
    int chosen = -1;
    bool between = false;  // May the cheapest lie next to the fastest?
    for (int k = 0; k < SlowerReaches::kCount; ++k) {
      Choice slower = Slower(SlowerReaches::kShares[k], k);
      if (k == 0) between = !slower.flight && best.flight;
      if (!(slower.cost < best.cost)) continue;
      best = std::move(slower);
      chosen = k;
    }
    if (chosen >= 0 || between) best = Refined(std::move(best), chosen);
    return std::move(best.flight);
  }

 private:
  Voyage At(double share) const {
    Voyage voyage = voyage_;
    voyage.motion.cruise_mps *= share;
    return voyage;
  }
  Choice Try(double share, const Reach& reach) const {
    const Voyage voyage = At(share);
    Choice choice;
    choice.share = share;
    choice.flight = Crossing(voyage, reach, to_, at_).Fastest();
    if (choice.flight) {
      const FlightPrice& price = voyage_.price;
      choice.cost = price.per_s * choice.flight->travel_s +
                    price.per_j * choice.flight->energy_j +
                    price.per_hazard_s * choice.flight->hazard_s;
    }
    return choice;
  }
  // At a speed close to the k-th slower one.
  Choice Slower(double share, int k) const {
    const Reach* reach = reach_.slower->At(k, voyage_, reach_.read);
    return reach ? Try(share, *reach) : Choice{};
  }
  // Golden section between the speeds on either side of the one chosen, which
  // has the least cost of the three; what cannot be flown costs infinitely.
  Choice Refined(Choice best, int chosen) const {
    const int last = SlowerReaches::kCount - 1;
    double low = chosen == last ? 0.0 : SlowerReaches::kShares[chosen + 1];
    double high = chosen <= 0 ? 1.0 : SlowerReaches::kShares[chosen - 1];
    for (int i = 0; i < kRefinements; ++i) {
      const bool up = high - best.share > best.share - low;
      const double share =
          up ? best.share + (1.0 - kGolden) * (high - best.share)
             : best.share - (1.0 - kGolden) * (best.share - low);
      Choice next = chosen < 0 ? Try(share, reach_) : Slower(share, chosen);
      const bool better = next.cost < best.cost;
      (up == better ? low : high) = better ? best.share : share;
      if (better) best = std::move(next);
    }
    return best;
  }

  const Voyage& voyage_;
  const Reach& reach_;
  kg_core::LonLat to_;
  kg_core::GridPoint at_;
};

}  // namespace

std::optional<Flight> Traverse(const Voyage& voyage, const Reach& reach,
                               kg_core::LonLat to) {
  const auto at = voyage.world.field->grid.Locate(to);
  if (!at) return std::nullopt;
  if (!(voyage.price.per_j > 0.0) || !reach.slower) {
    return Crossing(voyage, reach, to, *at).Fastest();
  }
  return Pricing(voyage, reach, to, *at).Cheapest();
}

}  // namespace kg_compiler
