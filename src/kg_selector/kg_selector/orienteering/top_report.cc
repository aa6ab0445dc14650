#include "kg_selector/orienteering/top_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include "kg_base/common/input_error.h"
#include "kg_selector/orienteering/top_instance.h"

namespace kg_selector {
namespace {

namespace fs = std::filesystem;

std::string SetName(const std::string& name) {
  return name.substr(0, name.find('.'));
}

TeamTours Solve(const std::string& path, const TeamTourOptions& options,
                double* seconds) {
  const kg_planner::OrienteeringProblem problem =
      ToOrienteering(ReadTopInstance(path));
  const TimeBudget clock(0.0);
  TeamTours team = PlanTours(problem, options);
  *seconds = clock.spent_s();
  const std::string fault = FindFault(problem, team);
  if (!fault.empty()) throw std::logic_error(path + ": " + fault);
  return team;
}

TopScore ScoreTeam(const TeamTours& team, double reference, double seconds) {
  TopScore score;
  score.seconds = seconds;
  if (team.value > reference + 1e-6) ++score.above;
  // The share of a reference of 0 is undefined: not counted.
  if (!(reference > 0.0)) return score;
  ++score.instances;
  if (team.value > reference - 1e-6) ++score.hits;
  score.value = team.value;
  score.reference = reference;
  score.shares = team.value / reference;
  if (std::isfinite(team.bound)) {
    ++score.bounds;
    score.bounded = team.value;
    score.bound = team.bound;
  }
  return score;
}

std::string FormatLine(const std::string& set, const TopScore& score) {
  char line[256];
  std::snprintf(
      line, sizeof line,
      "set %-6s %4d instances  share %7.2f %%  mean %7.2f %%  "
      "hits %4d  above %3d  seconds %8.2f  ",
      set.c_str(), score.instances, score.share(),
      score.instances > 0 ? 100.0 * score.shares / score.instances : 100.0,
      score.hits, score.above, score.seconds);
  std::string text = line;
  if (score.bounds == 0) return text + "no bound";
  std::snprintf(line, sizeof line, "%.2f %% of the bound of %d",
                score.bound > 0.0 ? 100.0 * score.bounded / score.bound : 100.0,
                score.bounds);
  return text + line;
}

}  // namespace

void TopScore::Add(const TopScore& other) {
  instances += other.instances;
  hits += other.hits;
  above += other.above;
  value += other.value;
  reference += other.reference;
  shares += other.shares;
  seconds += other.seconds;
  bounds += other.bounds;
  bounded += other.bounded;
  bound += other.bound;
}

double TopScore::share() const {
  return reference > 0.0 ? 100.0 * value / reference : 100.0;
}

std::vector<std::string> ListInstances(const std::string& folder,
                                       const std::string& reference_file) {
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;
    const std::string name = it->path().filename().string();
    if (name[0] == '.' || !it->is_regular_file(ignored)) continue;
    // The reference file may lie in the same folder.
    if (fs::equivalent(it->path(), reference_file, ignored)) continue;
    names.push_back(name);
  }
  if (error) {
    throw kg_base::InputError(folder + ": expected a folder of instances (" +
                              error.message() + ")");
  }
  if (names.empty()) {
    throw kg_base::InputError(folder + ": expected instances, found no file");
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::map<std::string, TopScore> RunTop(const std::string& folder,
                                       const std::string& reference_file,
                                       const TeamTourOptions& options,
                                       std::ostream* out, std::size_t step) {
  const auto references = ReadTopReferences(reference_file);
  const auto names = ListInstances(folder, reference_file);
  std::map<std::string, TopScore> sets;
  for (std::size_t i = 0; i < names.size(); i += step) {
    double seconds = 0.0;
    const TeamTours team =
        Solve((fs::path(folder) / names[i]).string(), options, &seconds);
    const auto reference = references.find(names[i]);
    if (reference == references.end()) {
      *out << names[i] << ": value " << team.value
           << ", no reference, not counted\n";
      continue;
    }
    // Sums by set, e.g. "p4" of "p4.2.a.txt".
    sets[SetName(names[i])].Add(ScoreTeam(team, reference->second, seconds));
  }
  for (const auto& [set, score] : sets) *out << FormatLine(set, score) << '\n';
  return sets;
}

}  // namespace kg_selector
