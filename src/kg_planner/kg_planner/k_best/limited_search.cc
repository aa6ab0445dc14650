#include "kg_planner/k_best/limited_search.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "kg_planner/k_best/reduction.h"
#include "kg_planner/k_best/token_unrolling.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

// Above the needs of realistic trellises; 40 MB.
constexpr std::size_t kMaxUnrolledSeams = 500000;

// Unrolls as many of the repeated tokens as possible.
void Unroll(LimitedSearch* limited) {
  std::vector<int> tokens = RepeatedTokens(limited->search);
  for (; !tokens.empty(); tokens.pop_back()) {
    auto unrolled =
        UnrollTokens(limited->search, tokens, limited->grid, kMaxUnrolledSeams);
    if (unrolled) {
      limited->search = std::move(*unrolled);
      return;
    }
    limited->tokens_are_exact = false;
  }
}

LimitedSearch MakePlain(const Trellis& trellis, PlainPass pass) {
  const ScoreGrid grid(pass.largest_total);
  const std::vector<char> sorted(trellis.stages.size(), 1);
  return {ToSearch(trellis, sorted, {}, grid),
          grid,
          pass.largest_total,
          ResourceLimits(trellis),
          true,
          std::move(pass.levels)};
}

}  // namespace

bool LimitedSearch::IsLimited() const {
  return std::any_of(limits.begin(), limits.end(), [](double limit) {
    return limit < std::numeric_limits<double>::infinity();
  });
}

LimitedSearch MakeSearch(const Trellis& trellis, const PathMasks& masks) {
  if (masks.nodes.empty() && masks.seams.empty()) {
    if (auto pass = PassPlain(trellis)) {
      return MakePlain(trellis, std::move(*pass));
    }
  }
  const TrellisSummary summary = CheckTrellis(trellis);
  const ScoreGrid grid(summary.largest_total);
  LimitedSearch limited{ToSearch(trellis, summary.sorted, masks, grid), grid,
                        summary.largest_total, ResourceLimits(trellis), true};
  DropUnaffordable(limited.limits, &limited.search);
  Unroll(&limited);
  return limited;
}

}  // namespace kg_planner
