#include "kg_planner/diverse_paths.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "kg_planner/limited_search.h"
#include "kg_planner/max_marginals.h"
#include "kg_planner/path_value.h"
#include "kg_planner/resource_prices.h"

namespace kg_planner {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// Of the dual prices; the last so high that only thrift counts.
constexpr double kPriceFactors[] = {0.0, 1.0, 2.0, 4.0, 1e4};

// The best path through a node of the caller's trellis.
struct Candidate {
  double score = kNone;
  std::size_t stage = 0;
  int origin_node = 0;
  int node = 0;           // Of the search: of nodes split from one, the best.
  std::size_t table = 0;  // Of the prices it was found under.
};

bool ComesFirst(const Candidate& a, const Candidate& b) {
  if (a.score != b.score) return a.score > b.score;
  if (a.stage != b.stage) return a.stage < b.stage;
  return a.origin_node < b.origin_node;
}

class DiverseSearch {
 public:
  DiverseSearch(const Trellis& trellis, const LimitedSearch& limited,
                const DiverseOptions& options)
      : trellis_(trellis),
        limited_(limited),
        paths_(static_cast<std::size_t>(std::max(options.paths, 1))),
        minimum_difference_(std::max(options.minimum_difference, 1)) {}

  // Without limits and with exact tokens.
  KBest FindExact() {
    tables_.emplace_back(limited_.search, limited_.grid, Prices());
    for (std::size_t s = 0; s < limited_.search.stages.size(); ++s)
      AddCandidates(s, [&](int node) { return Exact(s, node); });
    Take();
    if (!found_.paths.empty()) found_.bound = found_.paths.front().score();
    return std::move(found_);
  }

  // After the best path of all.
  KBest FindBehind(KBest best) {
    found_ = std::move(best);
    if (found_.paths.empty()) return std::move(found_);
    MakePricedTables();
    for (std::size_t s = 0; s < limited_.search.stages.size(); ++s)
      AddCandidates(s, [&](int node) { return Allowed(s, node); });
    Close(found_.paths.front());
    Take();
    const double last =
        found_.paths.size() < paths_ ? kNone : found_.paths.back().score();
    found_.proven =
        found_.proven && limited_.tokens_are_exact && !(most_uncertain_ > last);
    return std::move(found_);
  }

 private:
  template <typename Function>
  void AddCandidates(std::size_t s, const Function& find) {
    const SearchStage& stage = limited_.search.stages[s];
    std::vector<Candidate> best(stage.stage->nodes.size());
    for (int node = 0; node < stage.nodes; ++node) {
      Candidate candidate = find(node);
      Candidate& known = best[candidate.origin_node];
      if (candidate.score > known.score ||
          (candidate.score > kNone && candidate.score == known.score &&
           IsBetter(Value(candidate), Value(known))))
        known = candidate;
    }
    for (const Candidate& candidate : best)
      if (candidate.score > kNone) candidates_.push_back(candidate);
  }

  Candidate At(std::size_t s, int node) const {
    return {kNone, s, limited_.search.stages[s].OriginNode(node), node, 0};
  }
  Candidate Exact(std::size_t s, int node) const {
    Candidate candidate = At(s, node);
    candidate.score = tables_.front().Of(s, node);
    return candidate;
  }
  Candidate Allowed(std::size_t s, int node) {
    Candidate candidate = At(s, node);
    const double most = tables_.front().Of(s, node);
    if (!(most > kNone)) return candidate;
    for (std::size_t t = 0; t < tables_.size(); ++t) {
      candidate.table = t;
      const ValuedPath value = Value(candidate);
      if (!IsWithinLimits(trellis_, value.path)) continue;
      candidate.score = value.score;
      break;
    }
    if (candidate.score < most)
      most_uncertain_ = std::max(most_uncertain_, most);
    return candidate;
  }
  ValuedPath Value(const Candidate& candidate) const {
    return Evaluate(
        trellis_, limited_.grid, limited_.search,
        tables_[candidate.table].Seams(candidate.stage, candidate.node));
  }

  void MakePricedTables() {
    Prices dual = FindPrices(limited_).prices;
    dual.resize(limited_.limits.size(), 0.0);
    if (*std::max_element(dual.begin(), dual.end()) == 0.0)
      for (std::size_t r = 0; r < dual.size(); ++r)
        if (limited_.limits[r] < kNoLimit)
          dual[r] =
              0.1 * limited_.largest_total / std::max(limited_.limits[r], 1e-9);
    for (const double factor : kPriceFactors) {
      Prices prices = dual;
      for (double& price : prices) price *= factor;
      tables_.emplace_back(limited_.search, PricedGrid(limited_, prices),
                           prices);
    }
  }

  void Close(const Path& path) {
    for (MaxMarginals& table : tables_)
      table.CloseNear(path.nodes, minimum_difference_);
  }

  // Takes candidates that differ enough, best first.
  void Take() {
    std::sort(candidates_.begin(), candidates_.end(), ComesFirst);
    for (const Candidate& candidate : candidates_) {
      if (found_.paths.size() >= paths_) return;
      if (tables_[candidate.table].IsClosed(candidate.stage, candidate.node))
        continue;
      found_.paths.push_back(Value(candidate).path);
      Close(found_.paths.back());
    }
  }

  const Trellis& trellis_;
  const LimitedSearch& limited_;
  std::size_t paths_;
  int minimum_difference_;
  std::vector<MaxMarginals> tables_;  // By price.
  std::vector<Candidate> candidates_;
  double most_uncertain_ = kNone;  // Of nodes whose best path is not known.
  KBest found_;
};

}  // namespace

KBest FindDiverse(const Trellis& trellis, const Masks& masks,
                  const DiverseOptions& options) {
  const LimitedSearch limited = MakeSearch(trellis, masks);
  if (trellis.stages.empty()) return {};
  DiverseSearch search(trellis, limited, options);
  KBest found = !limited.IsLimited() && limited.tokens_are_exact
                    ? search.FindExact()
                    : search.FindBehind(FindKBest(
                          trellis, masks, {1, options.enumeration_limit}));
  if (options.paths <= 0) found.paths.clear();
  return found;
}

}  // namespace kg_planner
