#include "kg_planner/k_best/k_best.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "kg_planner/k_best/k_best_memory.h"
#include "kg_planner/k_best/limited_search.h"
#include "kg_planner/k_best/no_value.h"
#include "kg_planner/k_best/path_enumerator.h"
#include "kg_planner/k_best/path_value.h"
#include "kg_planner/k_best/resource_prices.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

// Paths enumerated before resources are priced.
constexpr std::size_t kUnpricedPaths = 500;

// The best paths so far, at most `paths`.
class PathShortlist {
 public:
  explicit PathShortlist(int paths) : paths_(paths) {}

  void Add(ValuedPath found) {
    const auto place =
        std::lower_bound(found_.begin(), found_.end(), found, IsBetter);
    // Already in the list.
    if (place != found_.end() && !IsBetter(found, *place)) return;
    found_.insert(place, std::move(found));
    if (found_.size() > paths_) found_.pop_back();
  }
  // True if no later path, in order of bounds, can enter the list.
  bool IsClosedTo(double bound, const ValuedPath& found) const {
    if (found_.size() < paths_) return false;
    const ValuedPath& last = found_.back();
    if (bound != last.score) return bound < last.score;
    return last.places < found.places;
  }
  // `bound`: upper bound of the paths not enumerated.
  KBest Result(bool proven, double bound) {
    KBest best;
    best.proven = proven;
    best.bound = bound;
    for (ValuedPath& found : found_) {
      best.bound = std::max(best.bound, found.path.score());
      best.paths.push_back(std::move(found.path));
    }
    return best;
  }

 private:
  std::size_t paths_;
  std::vector<ValuedPath> found_;
};

class KBestSearch {
 public:
  // `memory` may be null.
  KBestSearch(const Trellis& trellis, LimitedSearch limited, int paths,
              KBestMemory* memory)
      : trellis_(trellis),
        limited_(std::move(limited)),
        shortlist_(paths),
        memory_(memory) {}

  KBest Find(std::size_t enumeration_limit) {
    const std::size_t unpriced =
        limited_.IsLimited() ? std::min(kUnpricedPaths, enumeration_limit)
                             : enumeration_limit;
    const auto left = EnumerateUnpriced(unpriced);
    if (!left) return shortlist_.Result(true, kNone);
    if (unpriced == enumeration_limit) return shortlist_.Result(false, *left);
    const ResourcePrices priced = FindPrices(limited_);
    if (priced.none_allowed) return shortlist_.Result(true, kNone);
    for (const std::vector<int>& seams : priced.tried) AddIfAllowed(seams);
    const auto rest =
        EnumerateUnder(priced.prices, enumeration_limit - unpriced);
    if (!rest) return shortlist_.Result(true, kNone);
    return shortlist_.Result(false, std::min(*left, *rest));
  }

 private:
  ValuedPath Value(const std::vector<int>& seams) const {
    return Evaluate(trellis_, limited_.grid, limited_.search, seams);
  }
  void AddIfAllowed(const std::vector<int>& seams) {
    ValuedPath found = Value(seams);
    if (IsWithinLimits(trellis_, found.path)) shortlist_.Add(std::move(found));
  }

  std::optional<double> EnumerateUnpriced(std::size_t limit) {
    PathEnumerator::Tables tables;
    if (memory_) tables = memory_->Recall(limited_.search, limited_.grid);
    if (!limited_.levels.empty()) tables.levels = std::move(limited_.levels);
    PathEnumerator enumerator(limited_.search, limited_.grid, {},
                              std::move(tables));
    const auto left = Enumerate(&enumerator, limit, 0.0);
    if (memory_) memory_->Keep(enumerator.Release());
    return left;
  }
  std::optional<double> EnumerateUnder(const Prices& prices,
                                       std::size_t limit) {
    const ScoreGrid grid = PricedGrid(limited_, prices);
    PathEnumerator enumerator(limited_.search, grid, prices);
    return Enumerate(&enumerator, limit, BoundOffset(limited_, grid, prices));
  }
  // If `limit` paths were not enough: an upper bound of the remaining paths.
  std::optional<double> Enumerate(PathEnumerator* enumerator, std::size_t limit,
                                  double offset) {
    for (std::size_t looked_at = 0;; ++looked_at) {
      const auto next = enumerator->Next();
      if (!next) return std::nullopt;
      ValuedPath found = Value(next->seams);
      const double bound = next->bound + offset;
      if (shortlist_.IsClosedTo(bound, found)) return std::nullopt;
      if (looked_at >= limit) return bound + Slack();
      if (IsWithinLimits(trellis_, found.path)) {
        shortlist_.Add(std::move(found));
      }
    }
  }
  // Margin by which a score may exceed its sum on the grid.
  double Slack() const {
    return 4.0 * static_cast<double>(trellis_.stages.size() + 1) *
           limited_.grid.step();
  }

  const Trellis& trellis_;
  LimitedSearch limited_;
  PathShortlist shortlist_;
  KBestMemory* memory_;
};

KBest FindWithinLimits(const Trellis& trellis, const PathMasks& masks,
                       const KBestOptions& options, KBestMemory* memory) {
  LimitedSearch limited = MakeSearch(trellis, masks);
  if (trellis.stages.empty()) return {};
  KBest found = KBestSearch(trellis, std::move(limited),
                            std::max(options.paths, 1), memory)
                    .Find(options.enumeration_limit);
  if (options.paths <= 0) found.paths.clear();
  return found;
}

// The trellis without limit r, in which a path is worth minus its use of r.
Trellis ThriftTrellis(const Trellis& trellis, std::size_t r) {
  Trellis thrift = trellis;
  for (Stage& stage : thrift.stages) {
    for (Node& node : stage.nodes) node = {};
    for (std::size_t i = 0; i < stage.seams.size(); ++i) {
      stage.seams[i].cost = SeamResource(stage, i, r);
    }
  }
  (r == 0 ? thrift.resource_limit : thrift.more_limits[r - 1]) = kNoLimit;
  return thrift;
}

std::vector<double> AboveLimits(const Trellis& trellis, const PathMasks& masks,
                                const KBestOptions& options) {
  const std::vector<double> limits = ResourceLimits(trellis);
  std::vector<double> above(limits.size(), kNoLimit);
  bool any = false;
  for (std::size_t r = 0; r < limits.size(); ++r) {
    if (!(limits[r] < kNoLimit)) continue;
    const KBest cheapest =
        FindWithinLimits(ThriftTrellis(trellis, r), masks,
                         {1, options.enumeration_limit}, nullptr);
    if (!(cheapest.bound > kNone)) continue;
    above[r] = -cheapest.bound - limits[r];
    any = true;
  }
  if (!any) above.clear();
  return above;
}

}  // namespace

KBest FindKBest(const Trellis& trellis, const PathMasks& masks,
                const KBestOptions& options) {
  return FindKBest(trellis, masks, options, nullptr);
}

KBest FindKBest(const Trellis& trellis, const PathMasks& masks,
                const KBestOptions& options, KBestMemory* memory) {
  KBest found = FindWithinLimits(trellis, masks, options, memory);
  if (found.bound == kNone) {
    found.above_limits = AboveLimits(trellis, masks, options);
  }
  return found;
}

}  // namespace kg_planner
