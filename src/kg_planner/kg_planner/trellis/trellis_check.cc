#include "kg_planner/trellis/trellis_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kg_planner {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

[[noreturn]] void Refuse(std::size_t stage, const std::string& where,
                         const std::string& what) {
  throw std::invalid_argument("stage " + std::to_string(stage) + ", " + where +
                              ": " + what);
}

[[noreturn]] void RefuseSeam(std::size_t stage, std::size_t index,
                             const Seam& seam, const std::string& what) {
  std::ostringstream where;
  where << "seam " << index << " (" << seam.from << " -> " << seam.to << ")";
  Refuse(stage, where.str(), what);
}

std::string Expected(const char* name, double value, const char* range) {
  std::ostringstream what;
  what << name << " is " << value << ", expected a finite number" << range;
  return what.str();
}

// False for NaN.
bool IsCost(double x) { return x >= 0.0 && x <= kLargest; }

void CheckNode(std::size_t stage, std::size_t index, const Node& node) {
  const std::string where = "node " + std::to_string(index);
  if (!std::isfinite(node.reward)) {
    Refuse(stage, where, Expected("reward", node.reward, ""));
  }
  for (const TokenReward& token : node.tokens) {
    if (!IsCost(token.reward)) {
      Refuse(
          stage, where,
          Expected(("reward of token " + std::to_string(token.token)).c_str(),
                   token.reward, " >= 0"));
    }
  }
}

bool SeamIsSound(const Seam& seam, int before, int nodes) {
  return seam.from >= 0 && seam.from < before && seam.to >= 0 &&
         seam.to < nodes && IsCost(seam.cost) && IsCost(seam.resource);
}

[[noreturn]] void ExplainSeam(std::size_t stage, std::size_t index,
                              const Seam& seam, int before) {
  if (!(seam.from >= 0 && seam.from < before)) {
    RefuseSeam(
        stage, index, seam,
        "from is not one of the " + std::to_string(before) + " nodes before");
  }
  if (!IsCost(seam.cost)) {
    RefuseSeam(stage, index, seam, Expected("cost", seam.cost, " >= 0"));
  }
  if (!IsCost(seam.resource)) {
    RefuseSeam(stage, index, seam,
               Expected("resource", seam.resource, " >= 0"));
  }
  RefuseSeam(stage, index, seam, "to is not one of the stage's nodes");
}

void CheckSeamsDiffer(std::size_t s, const Stage& stage) {
  std::vector<std::size_t> order(stage.seams.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (StandsBefore(stage, a, b)) return true;
    return !StandsBefore(stage, b, a) && a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (!StandsBefore(stage, order[i - 1], order[i])) {
      RefuseSeam(s, order[i], stage.seams[order[i]],
                 stage.via.empty() ? "the pair occurs twice"
                                   : "the pair occurs twice with the same via");
    }
  }
}

void CheckSeamVia(std::size_t s, const Stage& stage, std::size_t i) {
  const Seam& seam = stage.seams[i];
  std::vector<int> visited = stage.via[i];
  visited.push_back(seam.to);
  std::sort(visited.begin(), visited.end());
  for (std::size_t v = 0; v < visited.size(); ++v) {
    const std::string node = "via node " + std::to_string(visited[v]);
    if (visited[v] < 0 ||
        static_cast<std::size_t>(visited[v]) >= stage.nodes.size()) {
      RefuseSeam(s, i, seam, node + " is not one of the stage's nodes");
    }
    if (v > 0 && visited[v] == visited[v - 1]) {
      RefuseSeam(s, i, seam, node + " is visited twice");
    }
  }
}

// Precondition: the seams are valid.
void CheckVia(std::size_t s, const Stage& stage) {
  if (stage.via.empty()) return;
  if (stage.via.size() != stage.seams.size()) {
    Refuse(s, "via",
           "of " + std::to_string(stage.via.size()) + " seams, expected " +
               std::to_string(stage.seams.size()) + " or none");
  }
  for (std::size_t i = 0; i < stage.via.size(); ++i) CheckSeamVia(s, stage, i);
}

void CheckMoreResources(std::size_t s, const Stage& stage, std::size_t limits) {
  const auto& resources = stage.more_resources;
  if (resources.size() != limits) {
    Refuse(s, "more_resources",
           std::to_string(resources.size()) + " resources, expected " +
               std::to_string(limits) + " as in more_limits");
  }
  // Resource 0 is in the seams themselves, so these count from 1.
  for (std::size_t r = 0; r < resources.size(); ++r) {
    const std::string name = "resource " + std::to_string(r + 1);
    if (resources[r].size() != stage.seams.size()) {
      Refuse(s, name,
             "of " + std::to_string(resources[r].size()) + " seams, expected " +
                 std::to_string(stage.seams.size()));
    }
    for (std::size_t i = 0; i < resources[r].size(); ++i) {
      if (!IsCost(resources[r][i])) {
        RefuseSeam(s, i, stage.seams[i],
                   Expected(name.c_str(), resources[r][i], " >= 0"));
      }
    }
  }
}

std::uint64_t BitPattern(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

// Hot loop over every seam: maxima of bit patterns instead of comparisons. Read
// as unsigned, negative and nonfinite numbers are larger than any allowed
// value.
struct SeamMaxima {
  bool sorted = true;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint64_t cost = 0;
  std::uint64_t resource = 0;
};

SeamMaxima Maxima(const std::vector<Seam>& seams) {
  SeamMaxima maxima;
  std::int64_t last = -1;
  for (const Seam& seam : seams) {
    maxima.from = std::max(maxima.from, static_cast<std::uint32_t>(seam.from));
    maxima.to = std::max(maxima.to, static_cast<std::uint32_t>(seam.to));
    maxima.cost = std::max(maxima.cost, BitPattern(seam.cost));
    maxima.resource = std::max(maxima.resource, BitPattern(seam.resource));
    const std::int64_t ends = (std::int64_t{seam.from} << 32) + seam.to;
    maxima.sorted &= ends > last;
    last = ends;
  }
  return maxima;
}

struct SeamSummary {
  bool sorted = true;
  double largest_cost = 0.0;
};

SeamSummary SummarizeSeams(const Trellis& trellis, std::size_t s) {
  const std::vector<Seam>& seams = trellis.stages[s].seams;
  const int before = NodesBefore(trellis, s);
  const int nodes = static_cast<int>(trellis.stages[s].nodes.size());
  const SeamMaxima maxima = Maxima(seams);
  const bool sound = maxima.from < static_cast<std::uint32_t>(before) &&
                     maxima.to < static_cast<std::uint32_t>(nodes) &&
                     maxima.cost <= BitPattern(kLargest) &&
                     maxima.resource <= BitPattern(kLargest);
  SeamSummary summary{maxima.sorted, 0.0};
  std::memcpy(&summary.largest_cost, &maxima.cost, sizeof maxima.cost);
  if (!sound) summary.largest_cost = 0.0;
  // Invalid, or a -0.
  for (std::size_t i = 0; !sound && i < seams.size(); ++i) {
    if (!SeamIsSound(seams[i], before, nodes)) {
      ExplainSeam(s, i, seams[i], before);
    }
    summary.largest_cost = std::max(summary.largest_cost, seams[i].cost);
  }
  return summary;
}

bool Ascend(const Stage& stage) {
  for (std::size_t i = 1; i < stage.seams.size(); ++i) {
    if (!StandsBefore(stage, i - 1, i)) return false;
  }
  return true;
}

// Largest reward of a node, or of a seam's stops and end together.
double LargestReward(std::size_t s, const Stage& stage) {
  std::vector<double> totals;
  for (std::size_t i = 0; i < stage.nodes.size(); ++i) {
    CheckNode(s, i, stage.nodes[i]);
    totals.push_back(std::abs(stage.nodes[i].reward));
    for (const TokenReward& token : stage.nodes[i].tokens) {
      totals.back() += token.reward;
    }
  }
  double largest = 0.0;
  for (const double total : totals) largest = std::max(largest, total);
  for (std::size_t i = 0; i < stage.via.size(); ++i) {
    double total = totals[stage.seams[i].to];
    for (const int node : stage.via[i]) total += totals[node];
    largest = std::max(largest, total);
  }
  return largest;
}

void CheckLimits(const Trellis& trellis) {
  if (std::isnan(trellis.resource_limit)) {
    throw std::invalid_argument("resource limit is not a number");
  }
  for (std::size_t r = 0; r < trellis.more_limits.size(); ++r) {
    if (std::isnan(trellis.more_limits[r])) {
      throw std::invalid_argument("limit of resource " + std::to_string(r + 1) +
                                  " is not a number");
    }
  }
}

}  // namespace

bool StandsBefore(const Stage& stage, std::size_t a, std::size_t b) {
  const Seam& x = stage.seams[a];
  const Seam& y = stage.seams[b];
  if (x.from != y.from) return x.from < y.from;
  if (x.to != y.to) return x.to < y.to;
  return NodesVia(stage, a) < NodesVia(stage, b);
}

int NodesBefore(const Trellis& trellis, std::size_t stage) {
  return stage == 0 ? 1
                    : static_cast<int>(trellis.stages[stage - 1].nodes.size());
}

TrellisSummary CheckTrellis(const Trellis& trellis) {
  CheckLimits(trellis);
  TrellisSummary summary;
  for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
    const Stage& stage = trellis.stages[s];
    const SeamSummary seams = SummarizeSeams(trellis, s);
    CheckVia(s, stage);
    CheckMoreResources(s, stage, trellis.more_limits.size());
    const bool sorted = seams.sorted || Ascend(stage);
    if (!sorted) CheckSeamsDiffer(s, stage);
    summary.sorted.push_back(sorted);
    summary.largest_total += LargestReward(s, stage) + seams.largest_cost;
  }
  if (!std::isfinite(summary.largest_total)) {
    throw std::invalid_argument("the sum of all stages is not finite");
  }
  return summary;
}

}  // namespace kg_planner
