#include "kg_planner/k_best.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "kg_planner/path_enumerator.h"
#include "kg_planner/reduction.h"
#include "kg_planner/resource_prices.h"
#include "kg_planner/score_grid.h"
#include "kg_planner/search_trellis.h"
#include "kg_planner/survey.h"
#include "kg_planner/token_unrolling.h"

namespace kg_planner {
namespace {

// Larger than what unrolled tokens ask of any sensible trellis; 40 MB.
constexpr std::size_t kMaxUnrolledSeams = 500000;
constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// Looked at before the resources get prices.
constexpr std::size_t kUnpricedPaths = 500;

struct Found {
  double score = 0.0;       // On the grid.
  std::vector<int> places;  // Of its seams, in the order of ties.
  Path path;
};

bool Better(const Found& a, const Found& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.places < b.places;
}

// What a path over these seams is truly worth.
class Evaluator {
 public:
  Evaluator(const Trellis& trellis, const ScoreGrid& grid)
      : trellis_(trellis), grid_(grid) {}

  Found Evaluate(const SearchTrellis& search,
                 const std::vector<int>& seams) const {
    Found found;
    found.path.more_resources.assign(trellis_.more_limits.size(), 0.0);
    std::vector<TokenReward> met;
    for (std::size_t s = 0; s < seams.size(); ++s) {
      const int seam = search.stages[s].Origin(seams[s]);
      found.places.push_back(search.stages[s].Place(seams[s]));
      found.path.seams.push_back(seam);
      AddSeam(trellis_.stages[s], seam, &found, &met);
    }
    for (const TokenReward& token : Distinct(std::move(met))) {
      found.path.reward += token.reward;
      found.score += grid_.Round(token.reward);
    }
    return found;
  }

 private:
  void AddNode(const Node& node, Found* found,
               std::vector<TokenReward>* met) const {
    found->path.reward += node.reward;
    found->score += grid_.Round(node.reward);
    met->insert(met->end(), node.tokens.begin(), node.tokens.end());
  }
  void AddSeam(const Stage& stage, int index, Found* found,
               std::vector<TokenReward>* met) const {
    const Seam& seam = stage.seams[index];
    for (const int node : ViaOf(stage, index))
      AddNode(stage.nodes[node], found, met);
    AddNode(stage.nodes[seam.to], found, met);
    found->path.nodes.push_back(seam.to);
    found->path.cost += seam.cost;
    found->score -= grid_.Round(seam.cost);
    found->path.resource += seam.resource;
    for (std::size_t r = 0; r < found->path.more_resources.size(); ++r)
      found->path.more_resources[r] += stage.more_resources[r][index];
  }

  const Trellis& trellis_;
  ScoreGrid grid_;
};

bool IsWithinLimits(const Trellis& trellis, const Path& path) {
  if (!(path.resource <= trellis.resource_limit)) return false;
  for (std::size_t r = 0; r < path.more_resources.size(); ++r)
    if (!(path.more_resources[r] <= trellis.more_limits[r])) return false;
  return true;
}

// The best of those looked at, at most `paths`.
class Shortlist {
 public:
  explicit Shortlist(int paths) : paths_(paths) {}

  void Add(Found found) {
    const auto place =
        std::lower_bound(found_.begin(), found_.end(), found, Better);
    if (place != found_.end() && !Better(found, *place)) return;  // Known.
    found_.insert(place, std::move(found));
    if (found_.size() > paths_) found_.pop_back();
  }
  // Nothing from here on, in order of bounds, can enter the list.
  bool ClosedTo(double bound, const Found& found) const {
    if (found_.size() < paths_) return false;
    const Found& last = found_.back();
    if (bound != last.score) return bound < last.score;
    return last.places < found.places;
  }
  // `bound`: of the paths that were not looked at.
  KBest Result(bool proven, double bound) {
    KBest best;
    best.proven = proven;
    best.bound = bound;
    for (Found& found : found_) {
      best.bound = std::max(best.bound, found.path.score());
      best.paths.push_back(std::move(found.path));
    }
    return best;
  }

 private:
  std::size_t paths_;
  std::vector<Found> found_;
};

class Search {
 public:
  Search(const Trellis& trellis, const LimitedSearch& limited, int paths)
      : trellis_(trellis),
        limited_(limited),
        evaluator_(trellis, limited.grid),
        shortlist_(paths) {}

  KBest Find(std::size_t enumeration_limit) {
    const std::size_t unpriced =
        IsLimited() ? std::min(kUnpricedPaths, enumeration_limit)
                    : enumeration_limit;
    const auto left = Enumerate({}, unpriced);
    if (!left) return shortlist_.Result(true, kNone);
    if (unpriced == enumeration_limit) return shortlist_.Result(false, *left);
    const PricedSearch priced = FindPrices(limited_);
    if (priced.none_allowed) return shortlist_.Result(true, kNone);
    for (const std::vector<int>& seams : priced.tried) Look(seams);
    const auto rest = Enumerate(priced.prices, enumeration_limit - unpriced);
    if (!rest) return shortlist_.Result(true, kNone);
    return shortlist_.Result(false, std::min(*left, *rest));
  }

 private:
  bool IsLimited() const {
    return std::any_of(limited_.limits.begin(), limited_.limits.end(),
                       [](double limit) { return limit < kNoLimit; });
  }
  void Look(const std::vector<int>& seams) {
    Found found = evaluator_.Evaluate(limited_.search, seams);
    if (IsWithinLimits(trellis_, found.path)) shortlist_.Add(std::move(found));
  }

  // A bound of the paths that are left if `limit` paths were not enough.
  std::optional<double> Enumerate(const Prices& prices, std::size_t limit) {
    const ScoreGrid grid = PricedGrid(limited_, prices);
    const double offset = BoundOffset(limited_, grid, prices);
    PathEnumerator enumerator(limited_.search, grid, prices);
    for (std::size_t looked_at = 0;; ++looked_at) {
      const auto next = enumerator.Next();
      if (!next) return std::nullopt;
      Found found = evaluator_.Evaluate(limited_.search, next->seams);
      const double bound = next->bound + offset;
      if (shortlist_.ClosedTo(bound, found)) return std::nullopt;
      if (looked_at >= limit) return bound + Slack();
      if (IsWithinLimits(trellis_, found.path))
        shortlist_.Add(std::move(found));
    }
  }
  // What a score may be above its sum on the grid.
  double Slack() const {
    return 4.0 * static_cast<double>(trellis_.stages.size() + 1) *
           limited_.grid.step();
  }

  const Trellis& trellis_;
  const LimitedSearch& limited_;
  Evaluator evaluator_;
  Shortlist shortlist_;
};

SearchTrellis Unroll(SearchTrellis search, const ScoreGrid& grid) {
  std::vector<int> tokens = RepeatedTokens(search);
  for (; !tokens.empty(); tokens.pop_back()) {
    auto unrolled = UnrollTokens(search, tokens, grid, kMaxUnrolledSeams);
    if (unrolled) return std::move(*unrolled);
  }
  return search;
}

KBest FindWithinLimits(const Trellis& trellis, const Masks& masks,
                       const KBestOptions& options) {
  const Survey survey = CheckAndSurvey(trellis);
  const ScoreGrid grid(survey.largest_total);
  SearchTrellis search = ToSearch(trellis, masks, grid);
  if (trellis.stages.empty()) return {};
  const std::vector<double> limits = LimitsOf(trellis);
  DropUnaffordable(limits, &search);
  search = Unroll(std::move(search), grid);
  const LimitedSearch limited{search, grid, survey.largest_total, limits};
  KBest found = Search(trellis, limited, std::max(options.paths, 1))
                    .Find(options.enumeration_limit);
  if (options.paths <= 0) found.paths.clear();
  return found;
}

// The same without limit r, every path worth minus what it uses of r.
Trellis ThriftOf(const Trellis& trellis, std::size_t r) {
  Trellis thrift = trellis;
  for (Stage& stage : thrift.stages) {
    for (Node& node : stage.nodes) node = {};
    for (std::size_t i = 0; i < stage.seams.size(); ++i)
      stage.seams[i].cost = ResourceOf(stage, i, r);
  }
  (r == 0 ? thrift.resource_limit : thrift.more_limits[r - 1]) = kNoLimit;
  return thrift;
}

std::vector<double> AboveLimits(const Trellis& trellis, const Masks& masks,
                                const KBestOptions& options) {
  const std::vector<double> limits = LimitsOf(trellis);
  std::vector<double> above(limits.size(), kNoLimit);
  bool any = false;
  for (std::size_t r = 0; r < limits.size(); ++r) {
    if (!(limits[r] < kNoLimit)) continue;
    const KBest thriftiest = FindWithinLimits(ThriftOf(trellis, r), masks,
                                              {1, options.enumeration_limit});
    if (!(thriftiest.bound > kNone)) continue;
    above[r] = -thriftiest.bound - limits[r];
    any = true;
  }
  if (!any) above.clear();
  return above;
}

}  // namespace

KBest FindKBest(const Trellis& trellis, const Masks& masks,
                const KBestOptions& options) {
  KBest found = FindWithinLimits(trellis, masks, options);
  if (found.bound == kNone)
    found.above_limits = AboveLimits(trellis, masks, options);
  return found;
}

}  // namespace kg_planner
