#include "kg_planner/k_best/resource_prices.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace kg_planner {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr int kSecants = 30;
constexpr int kDoublings = 60;
constexpr int kSteps = 120;

// The best path under prices: what it is worth without them, what it uses, and
// the bound that the prices give.
struct PricedPath {
  double value = 0.0;
  std::vector<double> use;
  double bound = 0.0;
};

class PriceFinder {
 public:
  explicit PriceFinder(const LimitedSearch& search) : search_(search) {
    for (std::size_t r = 0; r < search.limits.size(); ++r)
      if (search.limits[r] < kNoLimit) limited_.push_back(r);
  }

  ResourcePrices Find() {
    const auto free = BestUnder(Prices(search_.limits.size(), 0.0));
    if (!free || limited_.empty() || IsAllowed(*free)) return std::move(found_);
    if (limited_.size() == 1)
      Secants(limited_.front(), *free);
    else
      Steps(*free);
    return std::move(found_);
  }

 private:
  bool IsAllowed(const PricedPath& path) const {
    for (const std::size_t r : limited_)
      if (!(path.use[r] <= search_.limits[r])) return false;
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
      for (std::size_t s = 0; s < best->seams.size(); ++s)
        path.use[r] += search_.search.stages[s].Resource(best->seams[s], r);
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

  void Secants(std::size_t r, PricedPath dear) {
    const double limit = search_.limits[r];
    double price = search_.largest_total / dear.use[r];
    PricedPath cheap = BestAt(r, price);
    for (int i = 0; i < kDoublings && !IsAllowed(cheap); ++i)
      cheap = BestAt(r, price *= 2.0);
    for (int i = 0; i < kSecants && cheap.use[r] < dear.use[r]; ++i) {
      price = (dear.value - cheap.value) / (dear.use[r] - cheap.use[r]);
      const PricedPath best = BestAt(r, price);
      const double gain =
          best.value - cheap.value - price * (best.use[r] - cheap.use[r]);
      if (!(gain > 1e-9 * search_.largest_total)) break;
      (best.use[r] <= limit ? cheap : dear) = best;
    }
    found_.prices.assign(search_.limits.size(), 0.0);
    found_.prices[r] = std::max(price, 0.0);
  }

  // Prices are per share of the limit: resources may be of any size.
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

  void Steps(PricedPath at) {
    Prices prices(search_.limits.size(), 0.0);
    found_.prices = prices;
    double least = at.bound;
    double reach = 0.25 * search_.largest_total;  // Of the level, below least.
    int idle = 0;
    for (int i = 0; i < kSteps && !found_.none_allowed; ++i) {
      const Prices next = Step(prices, at, least - reach);
      if (next == prices) break;
      prices = next;
      at = *BestUnder(prices);
      idle = at.bound < least ? 0 : idle + 1;
      if (at.bound < least) {
        least = at.bound;
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
  double most = 0.0;
  for (int i = 0; i < stage.seam_count; ++i)
    most = std::max(most, stage.Resource(i, r));
  return most;
}

}  // namespace

ScoreGrid PricedGrid(const LimitedSearch& search, const Prices& prices) {
  if (!HasPrice(prices)) return search.grid;
  double largest = search.largest_total;
  for (const SearchStage& stage : search.search.stages)
    for (std::size_t r = 0; r < prices.size(); ++r)
      if (prices[r] > 0.0) largest += prices[r] * LargestUse(stage, r);
  return ScoreGrid(largest);
}

double BoundOffset(const LimitedSearch& search, const ScoreGrid& grid,
                   const Prices& prices) {
  if (!HasPrice(prices)) return 0.0;
  double worth = 0.0;
  for (std::size_t r = 0; r < prices.size(); ++r)
    if (prices[r] > 0.0) worth += prices[r] * search.limits[r];
  const double stages = static_cast<double>(search.search.stages.size());
  return worth + 4.0 * (stages + 1.0) * grid.step() + 4e-16 * stages * worth;
}

ResourcePrices FindPrices(const LimitedSearch& search) {
  return PriceFinder(search).Find();
}

}  // namespace kg_planner
