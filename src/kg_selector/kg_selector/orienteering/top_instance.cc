#include "kg_selector/orienteering/top_instance.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_selector {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 24;
constexpr int kMaxPoints = 2000;  // All pairwise lengths are stored.
constexpr int kMaxPaths = 1000;

struct FileLine {
  std::size_t number = 0;  // Line number, from 1.
  std::vector<std::string_view> fields;
};

std::vector<std::string_view> SplitFields(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  std::vector<std::string_view> fields;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, begin);
    fields.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return fields;
}

// Non-empty lines.
std::vector<FileLine> SplitLines(std::string_view text) {
  std::vector<FileLine> lines;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    FileLine line{++number, SplitFields(text.substr(0, end))};
    if (!line.fields.empty()) lines.push_back(std::move(line));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

class InstanceReader {
 public:
  explicit InstanceReader(const std::string& path)
      : path_(path),
        text_(kg_base::ReadFile(path, kMaxBytes)),
        lines_(SplitLines(text_)) {}

  const std::vector<FileLine>& lines() const { return lines_; }

  [[noreturn]] void Refuse(const FileLine& line,
                           const std::string& expected) const {
    throw kg_base::InputError(path_ + ":" + std::to_string(line.number) +
                              ": expected " + expected);
  }
  [[noreturn]] void RefuseEnd(const std::string& expected) const {
    throw kg_base::InputError(path_ + ": ends too soon, expected " + expected);
  }

  double Number(const FileLine& line, std::size_t field,
                const std::string& what) const {
    const std::string_view text = line.fields[field];
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() ||
        !std::isfinite(value)) {
      Refuse(line, what + ", a number");
    }
    return value;
  }

  // Value of the header line `index`, which must have this key.
  double Header(std::size_t index, const std::string& key) const {
    if (index >= lines_.size()) RefuseEnd("'" + key + " <number>'");
    const FileLine& line = lines_[index];
    if (line.fields.size() != 2 || line.fields[0] != key) {
      Refuse(line, "'" + key + " <number>'");
    }
    return Number(line, 1, key);
  }
  int Count(std::size_t index, const std::string& key, int min_value,
            int max_value) const {
    const double value = Header(index, key);
    if (!(value >= min_value && value <= max_value &&
          value == std::floor(value))) {
      Refuse(lines_[index], key + " a whole number from " +
                                std::to_string(min_value) + " to " +
                                std::to_string(max_value));
    }
    return static_cast<int>(value);
  }

 private:
  const std::string path_;
  const std::string text_;  // Storage of the lines' string_views.
  const std::vector<FileLine> lines_;
};

void ReadPoint(const InstanceReader& reader, const FileLine& line,
               TopInstance* instance) {
  if (line.fields.size() != 3) reader.Refuse(line, "x, y and score of a point");
  instance->x.push_back(reader.Number(line, 0, "x"));
  instance->y.push_back(reader.Number(line, 1, "y"));
  const double score = reader.Number(line, 2, "score");
  if (!(score >= 0.0)) reader.Refuse(line, "a score not below 0");
  instance->scores.push_back(score);
}

}  // namespace

TopInstance ReadTopInstance(const std::string& path) {
  constexpr std::size_t kHeaders = 3;
  const InstanceReader reader(path);
  TopInstance instance;
  const int points = reader.Count(0, "n", 2, kMaxPoints);
  instance.paths = reader.Count(1, "m", 1, kMaxPaths);
  instance.limit = reader.Header(2, "tmax");
  if (!(instance.limit >= 0.0)) {
    reader.Refuse(reader.lines()[2], "tmax not below 0");
  }
  // One line per point; a wrong count is an error.
  for (std::size_t i = kHeaders; i < reader.lines().size(); ++i) {
    const FileLine& line = reader.lines()[i];
    if (static_cast<int>(i - kHeaders) == points) {
      reader.Refuse(line, "no more than " + std::to_string(points) + " points");
    }
    ReadPoint(reader, line, &instance);
  }
  if (static_cast<int>(instance.scores.size()) < points) {
    reader.RefuseEnd(std::to_string(points) + " points, found " +
                     std::to_string(instance.scores.size()));
  }
  return instance;
}

std::map<std::string, double> ReadTopReferences(const std::string& path) {
  const InstanceReader reader(path);
  std::map<std::string, double> references;
  for (const FileLine& line : reader.lines()) {
    if (line.fields.size() != 2) reader.Refuse(line, "a file name and a value");
    const double value = reader.Number(line, 1, "value");
    if (!(value >= 0.0)) reader.Refuse(line, "a value not below 0");
    if (!references.emplace(std::string(line.fields[0]), value).second) {
      reader.Refuse(line, "each file name once");
    }
  }
  return references;
}

kg_planner::OrienteeringProblem ToOrienteering(const TopInstance& instance) {
  kg_planner::OrienteeringProblem problem;
  problem.rewards = instance.scores;
  problem.rewards.front() = problem.rewards.back() = 0.0;
  for (std::size_t i = 0; i < instance.x.size(); ++i) {
    for (std::size_t j = 0; j < instance.x.size(); ++j) {
      problem.lengths.push_back(std::hypot(instance.x[i] - instance.x[j],
                                           instance.y[i] - instance.y[j]));
    }
  }
  problem.limit = instance.limit + kLengthSlack;
  problem.tours = instance.paths;
  return problem;
}

}  // namespace kg_selector
