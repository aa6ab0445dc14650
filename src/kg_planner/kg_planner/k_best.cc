#include "kg_planner/k_best.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "kg_planner/path_enumerator.h"
#include "kg_planner/reduction.h"
#include "kg_planner/score_grid.h"
#include "kg_planner/survey.h"
#include "kg_planner/token_unrolling.h"

namespace kg_planner {
namespace {

// Larger than what unrolled tokens ask of any sensible trellis; 20 MB.
constexpr std::size_t kMaxUnrolledSeams = 500000;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// Looked at before the resource gets a price.
constexpr std::size_t kUnpricedPaths = 500;

struct Found {
  double score = 0.0;  // On the grid.
  Path path;
};

bool Better(const Found& a, const Found& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.path.nodes < b.path.nodes;
}

void AddTokens(const ScoreGrid& grid, const std::vector<TokenReward>& met,
               Found* found) {
  std::map<int, double> best;
  for (const TokenReward& token : met)
    best[token.token] = std::max(best[token.token], token.reward);
  for (const auto& [token, reward] : best) {
    found->path.reward += reward;
    found->score += grid.Round(reward);
  }
}

// What the path is truly worth.
Found Evaluate(const Trellis& trellis, const ScoreGrid& grid,
               const std::vector<int>& seams) {
  Found found;
  std::vector<TokenReward> met;
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const Seam& seam = trellis.stages[s].seams[seams[s]];
    const Node& node = trellis.stages[s].nodes[seam.to];
    found.path.nodes.push_back(seam.to);
    found.path.reward += node.reward;
    found.path.cost += seam.cost;
    found.path.resource += seam.resource;
    found.score += grid.Round(node.reward) - grid.Round(seam.cost);
    met.insert(met.end(), node.tokens.begin(), node.tokens.end());
  }
  if (!met.empty()) AddTokens(grid, met, &found);
  return found;
}

// The best of those looked at, at most `paths`.
class Shortlist {
 public:
  explicit Shortlist(int paths) : paths_(paths) {}

  void Add(Found found) {
    found_.insert(std::upper_bound(found_.begin(), found_.end(), found, Better),
                  std::move(found));
    if (found_.size() > paths_) found_.pop_back();
  }
  // Nothing from here on, in order of bounds, can enter the list.
  bool ClosedTo(double bound, const Found& found) const {
    if (found_.size() < paths_) return false;
    const Found& last = found_.back();
    if (bound != last.score) return bound < last.score;
    return last.path.nodes < found.path.nodes;
  }
  std::vector<Path> Paths() {
    std::vector<Path> paths;
    for (Found& found : found_) paths.push_back(std::move(found.path));
    return paths;
  }

 private:
  std::size_t paths_;
  std::vector<Found> found_;
};

struct Search {
  const Trellis& trellis;
  ScoreGrid grid;
  double largest_total = 0.0;
};

// Scores of paths under a price, for which the grid may be too fine.
ScoreGrid PricedGrid(const Search& search, double price) {
  if (!(price > 0.0)) return search.grid;
  double largest = search.largest_total;
  for (const Stage& stage : search.trellis.stages) {
    double most = 0.0;
    for (const Seam& seam : stage.seams) most = std::max(most, seam.resource);
    largest += price * most;
  }
  return ScoreGrid(largest);
}

// How far the bound of an allowed path may lie below its score: the limit's
// worth, and what rounding can do.
double BoundOffset(const Search& search, const ScoreGrid& grid, double price) {
  if (!(price > 0.0)) return 0.0;
  const double limit = search.trellis.resource_limit;
  const double stages = static_cast<double>(search.trellis.stages.size());
  return price * limit + 4.0 * (stages + 1.0) * grid.step() +
         4e-16 * stages * price * limit;
}

KBest Proven(std::vector<Path> paths) {
  KBest found;
  if (!paths.empty()) found.bound = paths.front().score();
  found.paths = std::move(paths);
  return found;
}

KBest Enumerate(const Search& search, double price, int paths,
                std::size_t limit) {
  const ScoreGrid grid = PricedGrid(search, price);
  const double offset = BoundOffset(search, grid, price);
  PathEnumerator enumerator(search.trellis, grid, price);
  Shortlist shortlist(paths);
  for (std::size_t looked_at = 0;; ++looked_at) {
    const auto next = enumerator.Next();
    if (!next) return Proven(shortlist.Paths());
    Found found = Evaluate(search.trellis, search.grid, next->seams);
    if (shortlist.ClosedTo(next->bound + offset, found))
      return Proven(shortlist.Paths());
    if (looked_at >= limit)
      return {shortlist.Paths(), false, next->bound + offset, {}};
    if (found.path.resource <= search.trellis.resource_limit)
      shortlist.Add(std::move(found));
  }
}

// The best path under a price: what it is worth without it, and what it uses.
struct PricedPath {
  double value = 0.0;
  double resource = 0.0;
};

PricedPath BestUnder(const Search& search, double price) {
  const ScoreGrid grid = PricedGrid(search, price);
  const auto best = PathEnumerator(search.trellis, grid, price).Next();
  PricedPath path;
  for (std::size_t s = 0; best && s < best->seams.size(); ++s)
    path.resource += search.trellis.stages[s].seams[best->seams[s]].resource;
  if (best) path.value = best->bound + price * path.resource;
  return path;
}

// The price that makes the bound of allowed paths least: the dual of the
// resource limit, by the secants of A. Juttner et al., "Lagrange relaxation
// based method for the QoS routing problem", INFOCOM 2001.
double ResourcePrice(const Search& search) {
  const double limit = search.trellis.resource_limit;
  PricedPath dear = BestUnder(search, 0.0);
  if (dear.resource <= limit) return 0.0;
  double price = search.largest_total / dear.resource;
  PricedPath cheap = BestUnder(search, price);
  for (int i = 0; i < 60 && cheap.resource > limit; ++i) {
    price *= 2.0;
    cheap = BestUnder(search, price);
  }
  for (int i = 0; i < 30 && cheap.resource < dear.resource; ++i) {
    price = (dear.value - cheap.value) / (dear.resource - cheap.resource);
    const PricedPath best = BestUnder(search, price);
    const double gain =
        best.value - cheap.value - price * (best.resource - cheap.resource);
    if (!(gain > 1e-9 * search.largest_total)) break;
    (best.resource <= limit ? cheap : dear) = best;
  }
  return std::max(price, 0.0);
}

KBest FindInReduced(const Search& search, const KBestOptions& options) {
  const bool limited = search.trellis.resource_limit < kNoLimit;
  const std::size_t limit = options.enumeration_limit;
  const std::size_t unpriced =
      limited ? std::min(kUnpricedPaths, limit) : limit;
  KBest found = Enumerate(search, 0.0, options.paths, unpriced);
  if (found.proven || unpriced == limit) return found;
  const double price = ResourcePrice(search);
  return Enumerate(search, price, options.paths, limit - unpriced);
}

Unrolled Unroll(Trellis trellis, const ScoreGrid& grid) {
  std::vector<int> tokens = RepeatedTokens(trellis);
  for (; !tokens.empty(); tokens.pop_back()) {
    auto unrolled = UnrollTokens(trellis, tokens, grid, kMaxUnrolledSeams);
    if (unrolled) return std::move(*unrolled);
  }
  return {std::move(trellis), {}};
}

void ToOrigin(const Unrolled& unrolled, std::vector<Path>* paths) {
  if (unrolled.origin.empty()) return;
  for (Path& path : *paths)
    for (std::size_t s = 0; s < path.nodes.size(); ++s)
      path.nodes[s] = unrolled.origin[s][path.nodes[s]];
}

}  // namespace

KBest FindKBest(const Trellis& trellis, const Masks& masks,
                const KBestOptions& options) {
  const Survey survey = CheckAndSurvey(trellis);
  const ScoreGrid grid(survey.largest_total);
  const bool masked = !masks.nodes.empty() || !masks.seams.empty();
  const bool limited = trellis.resource_limit < kNoLimit;
  if (survey.sorted && !survey.has_tokens && !masked && !limited) {
    if (options.paths <= 0 || trellis.stages.empty()) return {};
    return FindInReduced({trellis, grid, survey.largest_total}, options);
  }
  Trellis reduced = DropUnaffordable(ApplyMasks(trellis, masks));
  if (options.paths <= 0 || trellis.stages.empty()) return {};
  const Unrolled unrolled = Unroll(std::move(reduced), grid);
  KBest found =
      FindInReduced({unrolled.trellis, grid, survey.largest_total}, options);
  ToOrigin(unrolled, &found.paths);
  return found;
}

}  // namespace kg_planner
