#include "kg_planner/k_best/diverse_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "kg_planner/k_best/detours.h"
#include "kg_planner/k_best/limited_search.h"
#include "kg_planner/k_best/max_marginals.h"
#include "kg_planner/k_best/no_value.h"
#include "kg_planner/k_best/path_value.h"
#include "kg_planner/k_best/resource_prices.h"

namespace kg_planner {
namespace {

// Ratio of consecutive penalties.
constexpr double kPenaltyStep = 1.1;
// Multiples of the dual prices to try; the last makes resource use dominate.
constexpr double kPriceFactors[] = {0.0, 1.0, 2.0, 4.0, 1e4};

// Best path through a node of the caller's trellis.
struct NodeCandidate {
  double score = kNone;
  std::size_t stage = 0;
  int origin_node = 0;
  int node = 0;           // Best of its split nodes in the search trellis.
  std::size_t table = 0;  // Index of the prices under which it was found.
};

bool ComesFirst(const NodeCandidate& a, const NodeCandidate& b) {
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
        minimum_difference_(std::max(options.minimum_difference, 1)),
        good_enough_(options.good_enough),
        detours_(options.detours) {}

  // Search without limits and with exact tokens.
  KBest FindExact() {
    MakeTable({});
    for (std::size_t s = 0; s < limited_.search.stages.size(); ++s) {
      AddCandidates(s, [&](int node) { return Exact(s, node); });
    }
    AddCandidatePaths();
    if (chosen_.empty()) return std::move(found_);
    found_.bound = chosen_.front().path.score();
    AddDetours();
    return Result();
  }

  // Search for the paths after the best one.
  KBest FindBelowBest(KBest best) {
    found_ = std::move(best);
    if (found_.paths.empty()) return std::move(found_);
    MakePricedTables();
    for (std::size_t s = 0; s < limited_.search.stages.size(); ++s) {
      AddCandidates(s, [&](int node) { return Allowed(s, node); });
    }
    AddPath(BestOfAll(found_.paths.front()));
    AddCandidatePaths();
    const double last =
        chosen_.size() < paths_ ? MinimumScore() : chosen_.back().path.score();
    found_.proven =
        found_.proven && limited_.tokens_are_exact && !(most_uncertain_ > last);
    AddDetours();
    return Result();
  }

 private:
  template <typename Function>
  void AddCandidates(std::size_t s, const Function& find) {
    const SearchStage& stage = limited_.search.stages[s];
    std::vector<NodeCandidate> best(stage.stage->nodes.size());
    for (int node = 0; node < stage.nodes; ++node) {
      NodeCandidate candidate = find(node);
      NodeCandidate& known = best[candidate.origin_node];
      // Best path through any of the nodes split from one; ties by the order of
      // ties.
      if (candidate.score > known.score ||
          (candidate.score > kNone && candidate.score == known.score &&
           IsBetter(Value(candidate), Value(known)))) {
        known = candidate;
      }
    }
    for (const NodeCandidate& candidate : best) {
      if (candidate.score > kNone) candidates_.push_back(candidate);
    }
  }

  NodeCandidate At(std::size_t s, int node) const {
    return {kNone, s, limited_.search.stages[s].OriginNode(node), node, 0};
  }
  NodeCandidate Exact(std::size_t s, int node) const {
    NodeCandidate candidate = At(s, node);
    candidate.score = tables_.front().Score(s, node);
    return candidate;
  }
  NodeCandidate Allowed(std::size_t s, int node) {
    NodeCandidate candidate = At(s, node);
    const double max_value = tables_.front().Score(s, node);
    if (!(max_value > kNone)) return candidate;
    for (std::size_t t = 0; t < tables_.size(); ++t) {
      candidate.table = t;
      const ValuedPath value = Value(candidate);
      if (!IsWithinLimits(trellis_, value.path)) continue;
      candidate.score = value.score;
      break;
    }
    if (candidate.score < max_value) {
      most_uncertain_ = std::max(most_uncertain_, max_value);
    }
    return candidate;
  }
  ValuedPath Value(const NodeCandidate& candidate) const {
    return Evaluate(
        trellis_, limited_.grid, limited_.search,
        tables_[candidate.table].Seams(candidate.stage, candidate.node));
  }

  void MakeTable(Prices prices) {
    grids_.push_back(PricedGrid(limited_, prices));
    // Levels of the checking pass are without prices.
    tables_.emplace_back(
        limited_.search, grids_.back(), prices,
        prices.empty() ? limited_.levels : std::vector<ViterbiLevel>());
    prices_.push_back(std::move(prices));
  }
  void MakePricedTables() {
    Prices dual = FindPrices(limited_).prices;
    dual.resize(limited_.limits.size(), 0.0);
    if (*std::max_element(dual.begin(), dual.end()) == 0.0) {
      for (std::size_t r = 0; r < dual.size(); ++r) {
        if (limited_.limits[r] < kNoLimit) {
          dual[r] =
              0.1 * limited_.largest_total / std::max(limited_.limits[r], 1e-9);
        }
      }
    }
    for (const double factor : kPriceFactors) {
      Prices prices = dual;
      for (double& price : prices) price *= factor;
      MakeTable(std::move(prices));
    }
  }

  // The best path as a ValuedPath; its rank among ties is irrelevant because it
  // is first.
  ValuedPath BestOfAll(const Path& path) const {
    return {kNoLimit, std::vector<int>(path.nodes.size(), -1), path};
  }

  // Minimum score of a path.
  double MinimumScore() const {
    if (chosen_.empty() || !(good_enough_ > kNone)) return kNone;
    const double best = chosen_.front().path.score();
    return best - (1.0 - good_enough_) * std::abs(best);
  }

  void AddPath(ValuedPath value) {
    for (MaxMarginals& table : tables_) {
      table.CloseNear(value.path.nodes, minimum_difference_);
    }
    chosen_.push_back(std::move(value));
  }

  // Adds candidates that differ enough, best first.
  void AddCandidatePaths() {
    std::sort(candidates_.begin(), candidates_.end(), ComesFirst);
    for (const NodeCandidate& candidate : candidates_) {
      if (chosen_.size() >= paths_ || candidate.score < MinimumScore()) return;
      if (!tables_[candidate.table].IsClosed(candidate.stage, candidate.node)) {
        AddPath(Value(candidate));
      }
    }
  }

  bool Differs(const Path& path) const {
    return std::all_of(chosen_.begin(), chosen_.end(),
                       [&](const ValuedPath& other) {
                         int stages = 0;
                         for (std::size_t s = 0; s < path.nodes.size(); ++s) {
                           stages += path.nodes[s] != other.path.nodes[s];
                         }
                         return stages >= minimum_difference_;
                       });
  }

  void AddDetours() {
    if (!detours_ || chosen_.size() >= paths_) return;
    const std::size_t t = tables_.size() > 1 ? 1 : 0;
    DetourSearch detours(limited_.search, grids_[t], prices_[t], tables_[t]);
    for (const ValuedPath& value : chosen_) detours.CountPath(value.path.nodes);
    // Starts at 1/256 of a mean stage: too weak to change the path at first.
    // Grows in steps of a tenth until the path differs enough.
    double penalty = limited_.largest_total * 0x1p-8 /
                     static_cast<double>(trellis_.stages.size());
    while (chosen_.size() < paths_) {
      auto detour = NextDetour(detours, &penalty);
      if (!detour) return;
      detours.CountPath(detour->path.nodes);
      chosen_.push_back(std::move(*detour));
    }
  }

  // Starts slightly below the last penalty: the more paths there are to differ
  // from, the smaller the penalty each one needs.
  std::optional<ValuedPath> NextDetour(const DetourSearch& detours,
                                       double* penalty) const {
    const double minimum = MinimumScore();
    for (*penalty /= kPenaltyStep * kPenaltyStep;
         *penalty < limited_.largest_total; *penalty *= kPenaltyStep) {
      ValuedPath value = Evaluate(trellis_, limited_.grid, limited_.search,
                                  detours.Best(*penalty));
      if (value.path.score() < minimum) return std::nullopt;
      if (IsWithinLimits(trellis_, value.path) && Differs(value.path)) {
        return value;
      }
    }
    return std::nullopt;
  }

  KBest Result() {
    std::stable_sort(chosen_.begin(), chosen_.end(),
                     [](const ValuedPath& a, const ValuedPath& b) {
                       return a.score > b.score;
                     });
    found_.paths.clear();
    for (ValuedPath& value : chosen_) {
      found_.paths.push_back(std::move(value.path));
    }
    return std::move(found_);
  }

  const Trellis& trellis_;
  const LimitedSearch& limited_;
  std::size_t paths_;
  int minimum_difference_;
  double good_enough_;
  bool detours_;
  std::vector<Prices> prices_;  // Prices tried, with their grids and tables.
  std::vector<ScoreGrid> grids_;
  std::vector<MaxMarginals> tables_;
  std::vector<NodeCandidate> candidates_;
  double most_uncertain_ =
      kNone;  // Largest bound of a node whose best path is unknown.
  std::vector<ValuedPath> chosen_;
  KBest found_;
};

}  // namespace

KBest FindDiverse(const Trellis& trellis, const PathMasks& masks,
                  const DiverseOptions& options) {
  const LimitedSearch limited = MakeSearch(trellis, masks);
  if (trellis.stages.empty()) return {};
  DiverseSearch search(trellis, limited, options);
  KBest found = !limited.IsLimited() && limited.tokens_are_exact
                    ? search.FindExact()
                    : search.FindBelowBest(FindKBest(
                          trellis, masks, {1, options.enumeration_limit}));
  if (options.paths <= 0) found.paths.clear();
  return found;
}

}  // namespace kg_planner
