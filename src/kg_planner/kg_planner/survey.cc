#include "kg_planner/survey.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
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

// NaN fails.
bool IsCost(double x) { return x >= 0.0 && x <= kLargest; }

void CheckNode(std::size_t stage, std::size_t index, const Node& node) {
  const std::string where = "node " + std::to_string(index);
  if (!std::isfinite(node.reward))
    Refuse(stage, where, Expected("reward", node.reward, ""));
  for (const TokenReward& token : node.tokens)
    if (!IsCost(token.reward))
      Refuse(
          stage, where,
          Expected(("reward of token " + std::to_string(token.token)).c_str(),
                   token.reward, " >= 0"));
}

bool SeamIsSound(const Seam& seam, int before, int nodes) {
  return seam.from >= 0 && seam.from < before && seam.to >= 0 &&
         seam.to < nodes && IsCost(seam.cost) && IsCost(seam.resource);
}

[[noreturn]] void ExplainSeam(std::size_t stage, std::size_t index,
                              const Seam& seam, int before) {
  if (!(seam.from >= 0 && seam.from < before))
    RefuseSeam(
        stage, index, seam,
        "from is not one of the " + std::to_string(before) + " nodes before");
  if (!IsCost(seam.cost))
    RefuseSeam(stage, index, seam, Expected("cost", seam.cost, " >= 0"));
  if (!IsCost(seam.resource))
    RefuseSeam(stage, index, seam,
               Expected("resource", seam.resource, " >= 0"));
  RefuseSeam(stage, index, seam, "to is not one of the stage's nodes");
}

bool Before(const Seam& a, const Seam& b) {
  return a.from < b.from || (a.from == b.from && a.to < b.to);
}

void CheckPairs(std::size_t stage, const std::vector<Seam>& seams) {
  std::vector<std::size_t> order(seams.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (Before(seams[a], seams[b])) return true;
    return !Before(seams[b], seams[a]) && a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (!Before(seams[order[i - 1]], seams[order[i]]))
      RefuseSeam(stage, order[i], seams[order[i]], "the pair occurs twice");
}

std::uint64_t Bits(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

// Every seam of the largest trellises passes here: maxima of bit patterns
// instead of comparisons. Read as unsigned, what is negative or not finite is
// larger than all that is allowed.
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
    maxima.cost = std::max(maxima.cost, Bits(seam.cost));
    maxima.resource = std::max(maxima.resource, Bits(seam.resource));
    const std::int64_t ends = (std::int64_t{seam.from} << 32) + seam.to;
    maxima.sorted &= ends > last;
    last = ends;
  }
  return maxima;
}

struct SeamSurvey {
  bool sorted = true;
  double largest_cost = 0.0;
};

SeamSurvey SurveySeams(const Trellis& trellis, std::size_t s) {
  const std::vector<Seam>& seams = trellis.stages[s].seams;
  const int before = NodesBefore(trellis, s);
  const int nodes = static_cast<int>(trellis.stages[s].nodes.size());
  const SeamMaxima maxima = Maxima(seams);
  const bool sound = maxima.from < static_cast<std::uint32_t>(before) &&
                     maxima.to < static_cast<std::uint32_t>(nodes) &&
                     maxima.cost <= Bits(kLargest) &&
                     maxima.resource <= Bits(kLargest);
  SeamSurvey survey{maxima.sorted, 0.0};
  std::memcpy(&survey.largest_cost, &maxima.cost, sizeof maxima.cost);
  if (!sound) survey.largest_cost = 0.0;
  for (std::size_t i = 0; !sound && i < seams.size(); ++i) {  // Or a -0.
    if (!SeamIsSound(seams[i], before, nodes))
      ExplainSeam(s, i, seams[i], before);
    survey.largest_cost = std::max(survey.largest_cost, seams[i].cost);
  }
  if (!survey.sorted) CheckPairs(s, seams);
  return survey;
}

double LargestReward(std::size_t s, const Stage& stage) {
  double largest = 0.0;
  for (std::size_t i = 0; i < stage.nodes.size(); ++i) {
    CheckNode(s, i, stage.nodes[i]);
    double total = std::abs(stage.nodes[i].reward);
    for (const TokenReward& token : stage.nodes[i].tokens)
      total += token.reward;
    largest = std::max(largest, total);
  }
  return largest;
}

}  // namespace

int NodesBefore(const Trellis& trellis, std::size_t stage) {
  return stage == 0 ? 1
                    : static_cast<int>(trellis.stages[stage - 1].nodes.size());
}

Survey CheckAndSurvey(const Trellis& trellis) {
  if (std::isnan(trellis.resource_limit))
    throw std::invalid_argument("resource limit is not a number");
  Survey survey;
  for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
    const Stage& stage = trellis.stages[s];
    survey.largest_total += LargestReward(s, stage);
    const SeamSurvey seams = SurveySeams(trellis, s);
    survey.largest_total += seams.largest_cost;
    survey.sorted = survey.sorted && seams.sorted;
    survey.has_tokens =
        survey.has_tokens ||
        std::any_of(stage.nodes.begin(), stage.nodes.end(),
                    [](const Node& node) { return !node.tokens.empty(); });
  }
  if (!std::isfinite(survey.largest_total))
    throw std::invalid_argument("the sum of all stages is not finite");
  return survey;
}

}  // namespace kg_planner
