#include "kg_base/raster/field_times.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/raster/axis_role.h"
#include "kg_base/raster/cf_time.h"
#include "kg_base/raster/coordinate_values.h"
#include "kg_base/raster/time_steps.h"

namespace kg_base {
namespace {

// Times that are nearer to each other differ by rounding.
constexpr double kSameTime_s = 0.5;

bool HasOneValue(const NetcdfFile& file, const NetcdfVariable& variable) {
  return std::all_of(
      variable.dimensions.begin(), variable.dimensions.end(),
      [&](int dimension) { return file.dimensions()[dimension].size == 1; });
}

bool IsListed(const NetcdfVariable& variable, const std::string& name) {
  std::istringstream names(variable.Text("coordinates"));
  std::string listed;
  while (names >> listed) {
    if (listed == name) return true;
  }
  return false;
}

// How clearly a single time is that of the variable: it is listed as its
// coordinate, has the standard name, is called time.
int ScoreOf(const NetcdfVariable& variable, const NetcdfVariable& time) {
  return 8 * (IsListed(variable, time.base_name) ? 1 : 0) +
         2 * RoleStrength(time) +
         (ToLowerAscii(time.base_name) == "time" ? 1 : 0);
}

std::vector<double> SecondsOf(const NetcdfFile& file,
                              const NetcdfVariable& time,
                              const NetcdfVariable& unit_source,
                              std::vector<double> values) {
  CfTime cf;
  try {
    cf = ParseCfTime(unit_source.Text("units"), unit_source.Text("calendar"));
  } catch (const InputError& error) {
    file.Refuse(time, error.what());
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = cf.epoch_s + values[i] * cf.unit_s;
    // Values beyond about 30,000 years are fill values. Negated comparison, to
    // catch NaN as well.
    if (!(std::abs(values[i]) < 1e12)) {
      file.Refuse(time, "time " + std::to_string(i) + " is missing");
    }
  }
  return values;
}

class TimesReader {
 public:
  TimesReader(const NetcdfFile& file, const NetcdfVariable& variable)
      : file_(file), variable_(variable) {}

  const NetcdfVariable* FindSingle(bool is_required) const;
  FieldTimes Read(const NetcdfVariable& time, TimeOrder order) {
    times_.time_s = SecondsOf(file_, time, time, CoordinateValues(file_, time));
    times_.in_file.resize(times_.time_s.size());
    std::iota(times_.in_file.begin(), times_.in_file.end(), std::size_t{0});
    MoveToMiddles(time);
    if (order == TimeOrder::kAscending) Sort();
    times_.issue_time_s = IssueTime_s();
    return std::move(times_);
  }

 private:
  std::string MethodAlong(const NetcdfVariable& time) const;
  const NetcdfVariable* BoundsOf(const NetcdfVariable& time) const;
  void MoveToMiddles(const NetcdfVariable& time);
  void Sort();
  void DropRepeatedTimes();
  double IssueTime_s() const;

  const NetcdfFile& file_;
  const NetcdfVariable& variable_;
  FieldTimes times_;
};

const NetcdfVariable* TimesReader::FindSingle(bool is_required) const {
  const NetcdfVariable* best = nullptr;
  const NetcdfVariable* rival = nullptr;
  std::string others;
  for (const NetcdfVariable& other : file_.variables()) {
    if (!IsTimeUnit(other.Text("units")) || !HasOneValue(file_, other) ||
        other.dimensions.size() > 1 || !other.IsVisibleTo(variable_)) {
      continue;
    }
    if (RoleOf(other) != AxisRole::kTime) {
      others += "; " + other.name + " is a reference or lead time";
      continue;
    }
    const int lead =
        best == nullptr ? 1
                        : ScoreOf(variable_, other) - ScoreOf(variable_, *best);
    if (lead == 0) rival = &other;
    if (lead > 0) {
      best = &other;
      rival = nullptr;
    }
  }
  if (rival != nullptr) {
    file_.Refuse(variable_, "its time could be " + best->name + " or " +
                                rival->name +
                                ", expected one with standard_name time");
  }
  if (best != nullptr || !is_required) return best;
  file_.Refuse(variable_,
               "expected a time (a dimension of it, or a scalar variable with "
               "units like \"hours since 2000-01-01 00:00:00\")" +
                   others);
}

// What cell_methods says about the time: "mean", "point", ...; "" if nothing.
std::string TimesReader::MethodAlong(const NetcdfVariable& time) const {
  std::istringstream words(variable_.Text("cell_methods"));
  std::string word;
  bool is_next = false;
  while (words >> word) {
    if (word.back() == ':') {
      // "time: lat: mean" applies one method to several dimensions.
      is_next = is_next || word == "time:" || word == time.base_name + ":";
    } else if (is_next) {
      return ToLowerAscii(word);
    }
  }
  return "";
}

const NetcdfVariable* TimesReader::BoundsOf(const NetcdfVariable& time) const {
  const std::string name = time.Text("bounds");
  for (const NetcdfVariable& other : file_.variables()) {
    if (name.empty() || other.base_name != name ||
        other.group_path != time.group_path) {
      continue;
    }
    const std::size_t own = time.dimensions.size();
    if (other.dimensions.size() == own + 1 &&
        std::equal(time.dimensions.begin(), time.dimensions.end(),
                   other.dimensions.begin()) &&
        file_.dimensions()[other.dimensions.back()].size == 2) {
      return &other;
    }
  }
  return nullptr;
}

// The stamp of a period may be its begin, middle or end; its value is taken to
// hold in the middle, as a point in time for interpolation.
void TimesReader::MoveToMiddles(const NetcdfVariable& time) {
  if (!time.Text("climatology").empty()) {
    times_.warnings.push_back(
        "values are a climatology, means over several years: taken for those "
        "at their stamps");
    return;
  }
  const std::string method = MethodAlong(time);
  if (method == "point") return;
  const NetcdfVariable* bounds = BoundsOf(time);
  if (bounds == nullptr) {
    const bool is_period = !method.empty() || !time.Text("bounds").empty();
    if (!is_period) return;
    times_.warnings.push_back(
        "values hold for periods (" +
        (method.empty() ? "bounds of " + time.name : "cell_methods " + method) +
        ") whose ends the file does not tell: taken to hold at their stamps");
    return;
  }
  const NetcdfVariable& unit = bounds->Text("units").empty() ? time : *bounds;
  const std::vector<double> ends_s =
      SecondsOf(file_, *bounds, unit, UnpackedValues(file_, *bounds));
  double moved_s = 0.0;
  for (std::size_t i = 0; i < times_.time_s.size(); ++i) {
    const double middle_s = 0.5 * (ends_s[2 * i] + ends_s[2 * i + 1]);
    moved_s = std::max(moved_s, std::abs(middle_s - times_.time_s[i]));
    times_.time_s[i] = middle_s;
  }
  if (moved_s < 1.0) return;
  std::ostringstream warning;
  warning << "values hold for the periods of " << bounds->name
          << ": taken to hold in their middles, up to " << moved_s / 3600.0
          << " h from their stamps";
  times_.warnings.push_back(warning.str());
}

void TimesReader::Sort() {
  const std::vector<double> time_s = times_.time_s;
  const bool is_one_way = std::is_sorted(time_s.begin(), time_s.end()) ||
                          std::is_sorted(time_s.rbegin(), time_s.rend());
  if (!is_one_way) {
    times_.warnings.push_back("times neither ascend nor descend: sorted");
  }
  std::stable_sort(
      times_.in_file.begin(), times_.in_file.end(),
      [&](std::size_t a, std::size_t b) { return time_s[a] < time_s[b]; });
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    times_.time_s[i] = time_s[times_.in_file[i]];
  }
  DropRepeatedTimes();
}

// The sort kept the file's order among equal times, so the last of them has the
// highest index in the file.
void TimesReader::DropRepeatedTimes() {
  std::vector<double> time_s;
  std::vector<std::size_t> in_file;
  std::string first;
  for (std::size_t i = 0; i < times_.time_s.size(); ++i) {
    const bool is_same =
        !time_s.empty() && times_.time_s[i] - time_s.back() < kSameTime_s;
    if (!is_same) {
      time_s.push_back(times_.time_s[i]);
      in_file.push_back(times_.in_file[i]);
      continue;
    }
    in_file.back() = std::max(in_file.back(), times_.in_file[i]);
    if (first.empty()) first = TimeText(time_s.back());
  }
  const std::size_t repeated = times_.time_s.size() - time_s.size();
  if (repeated == 0) return;
  times_.warnings.push_back(
      std::to_string(repeated) + " times are there more than once, the first " +
      "is " + first + ": of equal times the one written last is used");
  times_.time_s = std::move(time_s);
  times_.in_file = std::move(in_file);
}

// The reference time, if the file has one for all its values.
double TimesReader::IssueTime_s() const {
  for (const NetcdfVariable& other : file_.variables()) {
    if (other.Text("standard_name") != "forecast_reference_time" ||
        !HasOneValue(file_, other) || !other.IsVisibleTo(variable_) ||
        !IsTimeUnit(other.Text("units"))) {
      continue;
    }
    return SecondsOf(file_, other, other, CoordinateValues(file_, other))
        .front();
  }
  return std::nan("");
}

}  // namespace

FieldTimes ReadFieldTimes(const NetcdfFile& file,
                          const NetcdfVariable& variable,
                          const NetcdfVariable* along, bool is_required,
                          TimeOrder order) {
  TimesReader reader(file, variable);
  const NetcdfVariable* time =
      along != nullptr ? along : reader.FindSingle(is_required);
  if (time != nullptr) return reader.Read(*time, order);
  FieldTimes none;
  none.time_s = {std::nan("")};
  none.in_file = {0};
  return none;
}

}  // namespace kg_base
