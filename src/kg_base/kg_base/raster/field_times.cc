#include "kg_base/raster/field_times.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/raster/axis_role.h"
#include "kg_base/raster/cf_time.h"
#include "kg_base/raster/coordinate_values.h"

namespace kg_base {
namespace {

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
  FieldTimes Read(const NetcdfVariable& time) {
    times_.time_s = SecondsOf(file_, time, time, CoordinateValues(file_, time));
    MoveToMiddles(time);
    CheckAscending(time);
    return std::move(times_);
  }

 private:
  std::string MethodAlong(const NetcdfVariable& time) const;
  const NetcdfVariable* BoundsOf(const NetcdfVariable& time) const;
  void MoveToMiddles(const NetcdfVariable& time);
  void CheckAscending(const NetcdfVariable& time) const;

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

// What cell_methods says of the time: "mean", "point", ...; "" if nothing.
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

void TimesReader::CheckAscending(const NetcdfVariable& time) const {
  const std::vector<double>& time_s = times_.time_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] > time_s[i - 1]) continue;
    file_.Refuse(time,
                 "expected times that only ascend, time " + std::to_string(i) +
                     (time_s[i] == time_s[i - 1] ? " repeats" : " precedes") +
                     " the one before it");
  }
}

}  // namespace

FieldTimes ReadFieldTimes(const NetcdfFile& file,
                          const NetcdfVariable& variable,
                          const NetcdfVariable* along, bool is_required) {
  TimesReader reader(file, variable);
  const NetcdfVariable* time =
      along != nullptr ? along : reader.FindSingle(is_required);
  if (time == nullptr) return {{std::nan("")}, {}};
  return reader.Read(*time);
}

}  // namespace kg_base
