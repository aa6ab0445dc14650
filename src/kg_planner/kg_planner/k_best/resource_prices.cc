#include "kg_planner/k_best/resource_prices.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "kg_planner/k_best/no_value.h"

namespace kg_planner {
namespace {

constexpr int kMaxSecants = 30;
constexpr int kMaxDoublings = 60;
constexpr int kMaxSteps = 120;

// The best path under prices: its value without prices, its resource use, and
// the resulting bound.
struct PricedPath {
  double value = 0.0;
  std::vector<double> use;
  double bound = 0.0;
};

class PriceFinder {
 public:
  explicit PriceFinder(const LimitedSearch& search) : search_(search) {
    for (std::size_t r = 0; r < search.limits.size(); ++r) {
      if (search.limits[r] < kNoLimit) limited_.push_back(r);
    }
  }

  ResourcePrices Find() {
    const auto free = BestUnder(Prices(search_.limits.size(), 0.0));
    if (!free || limited_.empty() || IsAllowed(*free)) return std::move(found_);
    if (limited_.size() == 1) {
      SearchBySecants(limited_.front(), *free);
    } else {
      SearchBySubgradient(*free);
    }
    return std::move(found_);
  }

 private:
  bool IsAllowed(const PricedPath& path) const {
    for (const std::size_t r : limited_) {
      if (!(path.use[r] <= search_.limits[r])) return false;
    }
    return true;
  }

  std::optional<PricedPath> BestUnder(const Prices& prices) {
    const ScoreGrid grid = PricedGrid(search_, prices);
    const auto best = PathEnumerator(search_.search, grid, prices).Next();
    if (!best) return std::nullopt;
    PricedPath path;
    path.use.assign(search_.limits.size(), 0.0);
    path.value = best->bound;
    for (const std::size_t r : limited_) {
      for (std::size_t s = 0; s < best->seams.size(); ++s) {
        path.use[r] += search_.search.stages[s].Resource(best->seams[s], r);
      }
      path.value += prices[r] * path.use[r];
    }
    path.bound = best->bound + BoundOffset(search_, grid, prices);
    found_.tried.push_back(best->seams);
    // No path scores less than minus the largest total.
    if (path.bound < -2.0 * search_.largest_total) found_.none_allowed = true;
    return path;
  }

  PricedPath BestAt(std::size_t r, double price) {
    Prices prices(search_.limits.size(), 0.0);
    prices[r] = price;
    return *BestUnder(prices);
  }

  void SearchBySecants(std::size_t r, PricedPath over_limit) {
    // Bracket: a price too low (over the limit) and one high enough, found by
    // doubling. Initial price: largest total / use, which cancels the whole
    // value of a path.
    const double limit = search_.limits[r];
    double price = search_.largest_total / over_limit.use[r];
    PricedPath within_limit = BestAt(r, price);
    for (int i = 0; i < kMaxDoublings && !IsAllowed(within_limit); ++i) {
      within_limit = BestAt(r, price *= 2.0);
    }
    for (int i = 0; i < kMaxSecants && within_limit.use[r] < over_limit.use[r];
         ++i) {
      // Secant step: the price at which the two paths have equal value is the
      // corner of the dual between them.
      price = (over_limit.value - within_limit.value) /
              (over_limit.use[r] - within_limit.use[r]);
      const PricedPath best = BestAt(r, price);
      const double gain = best.value - within_limit.value -
                          price * (best.use[r] - within_limit.use[r]);
      // No path is better there: the corner is the minimum, up to rounding of
      // 1e-9 of the largest total.
      if (!(gain > 1e-9 * search_.largest_total)) break;
      (best.use[r] <= limit ? within_limit : over_limit) = best;
    }
    found_.prices.assign(search_.limits.size(), 0.0);
    found_.prices[r] = std::max(price, 0.0);
  }

  // Prices are scaled by the limit, because resources may have any magnitude.
  double Scale(std::size_t r) const {
    return search_.limits[r] > 0.0 ? search_.limits[r] : 1.0;
  }

  Prices Step(const Prices& prices, const PricedPath& at, double target) const {
    double square = 0.0;
    for (const std::size_t r : limited_) {
      const double over = (at.use[r] - search_.limits[r]) / Scale(r);
      if (over > 0.0 || prices[r] > 0.0) square += over * over;
    }
    Prices next = prices;
    if (!(square > 0.0)) return next;
    for (const std::size_t r : limited_) {
      const double over = (at.use[r] - search_.limits[r]) / Scale(r);
      next[r] += (at.bound - target) / square * over / Scale(r);
      next[r] = std::max(next[r], 0.0);
    }
    return next;
  }

  void SearchBySubgradient(PricedPath at) {
    Prices prices(search_.limits.size(), 0.0);
    found_.prices = prices;
    double min_value = at.bound;
    // Target level: initially a quarter of the largest total below the best
    // bound; the distance `reach` is halved after three steps without gain.
    double reach = 0.25 * search_.largest_total;
    int idle = 0;
    for (int i = 0; i < kMaxSteps && !found_.none_allowed; ++i) {
      const Prices next = Step(prices, at, min_value - reach);
      if (next == prices) break;
      prices = next;
      at = *BestUnder(prices);
      idle = at.bound < min_value ? 0 : idle + 1;
      if (at.bound < min_value) {
        min_value = at.bound;
        found_.prices = prices;
      }
      if (idle < 3) continue;
      reach /= 2.0;
      idle = 0;
    }
  }

  const LimitedSearch& search_;
  std::vector<std::size_t> limited_;
  ResourcePrices found_;
};

bool HasPrice(const Prices& prices) {
  return std::any_of(prices.begin(), prices.end(),
                     [](double price) { return price > 0.0; });
}

double LargestUse(const SearchStage& stage, std::size_t r) {
  double max_value = 0.0;
  for (int i = 0; i < stage.seam_count; ++i) {
    max_value = std::max(max_value, stage.Resource(i, r));
  }
  return max_value;
}

}  // namespace

ScoreGrid PricedGrid(const LimitedSearch& search, const Prices& prices) {
  if (!HasPrice(prices)) return search.grid;
  double largest = search.largest_total;
  for (const SearchStage& stage : search.search.stages) {
    for (std::size_t r = 0; r < prices.size(); ++r) {
      if (prices[r] > 0.0) largest += prices[r] * LargestUse(stage, r);
    }
  }
  return ScoreGrid(largest);
}

double BoundOffset(const LimitedSearch& search, const ScoreGrid& grid,
                   const Prices& prices) {
  if (!HasPrice(prices)) return 0.0;
  double worth = 0.0;
  for (std::size_t r = 0; r < prices.size(); ++r) {
    if (prices[r] > 0.0) worth += prices[r] * search.limits[r];
  }
  const double stages = static_cast<double>(search.search.stages.size());
  return worth + 4.0 * (stages + 1.0) * grid.step() + 4e-16 * stages * worth;
}

ResourcePrices FindPrices(const LimitedSearch& search) {
  return PriceFinder(search).Find();
}

}  // namespace kg_planner
