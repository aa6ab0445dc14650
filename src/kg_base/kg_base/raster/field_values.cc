#include "kg_base/raster/field_values.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

#include "kg_base/raster/coordinate_axis.h"
#include "kg_base/raster/coordinate_values.h"
#include "kg_base/raster/field_quantity.h"
#include "kg_base/raster/fill_values.h"
#include "kg_base/raster/outliers.h"
#include "kg_base/raster/time_steps.h"
#include "kg_base/raster/unit_conversion.h"

namespace kg_base {
namespace {

constexpr char kRemedy[] =
    "; a fill must be declared by _FillValue or missing_value, a unit by units";

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

UnitScale ScaleOf(const NetcdfFile& file, const NetcdfVariable& variable,
                  const QuantityWords& words, VariableReport* report) {
  if (words.unit.empty()) return {};
  const std::string units = variable.Text("units");
  if (units.empty()) {
    report->unit = words.unit;
    report->warnings.push_back("has no unit: taken as " + words.unit);
    return {};
  }
  const std::optional<UnitScale> scale = ConvertUnit(units, words.unit);
  if (!scale) {
    file.Refuse(variable, "unit \"" + units.substr(0, 100) +
                              "\" is not understood, expected for example \"" +
                              words.unit + "\"");
  }
  const bool is_same = scale->scale == 1.0 && scale->offset == 0.0;
  report->unit = is_same ? units : units + ", converted to " + words.unit;
  return *scale;
}

// Counts of raw values that are no plausible ones, for messages.
class OddValues {
 public:
  // `at`: index in the raster of the `time`-th time.
  void Add(double raw, std::size_t time, std::size_t at) {
    if (count_++ == 0) {
      first_time_ = time;
      first_at_ = at;
    }
    const auto found = counts_.find(raw);
    if (found != counts_.end()) {
      ++found->second;
    } else if (counts_.size() < kMaxDistinct) {
      counts_[raw] = 1;
    }
  }
  std::size_t count() const { return count_; }
  std::size_t first_time() const { return first_time_; }
  std::size_t first_at() const { return first_at_; }
  std::string Commonest() const {
    const auto most = std::max_element(
        counts_.begin(), counts_.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
    std::ostringstream text;
    text << std::setprecision(9) << most->first << " in " << most->second
         << " of them";
    return text.str();
  }

 private:
  static constexpr std::size_t kMaxDistinct = 1000;
  std::map<double, std::size_t> counts_;
  std::size_t count_ = 0;
  std::size_t first_time_ = 0;
  std::size_t first_at_ = 0;
};

class ValueUnpacker {
 public:
  ValueUnpacker(const NetcdfFile& file, const NetcdfVariable& variable,
                const QuantityWords& words, VariableReport* report)
      : fills_(file, variable), min_(words.min_value), max_(words.max_value) {
    const UnitScale unit = ScaleOf(file, variable, words, report);
    const double scale = SingleNumber(file, variable, "scale_factor", 1.0);
    const double offset = SingleNumber(file, variable, "add_offset", 0.0);
    if (scale == 0.0) {
      file.Refuse(variable, "attribute scale_factor: expected other than 0");
    }
    scale_ = scale * unit.scale;
    offset_ = offset * unit.scale + unit.offset;
  }

  // Converts the raw value of a cell to SI or NaN, and updates the counters.
  float operator()(double raw, std::size_t time, std::size_t at) {
    if (!std::isfinite(raw) || fills_.Contains(raw)) return kNoData;
    const double value = raw * scale_ + offset_;
    if (value >= min_ && value <= max_) {
      ++plausible_;
      return static_cast<float>(value);
    }
    odd_.Add(raw, time, at);
    return kNoData;
  }
  std::size_t plausible() const { return plausible_; }
  const OddValues& odd() const { return odd_; }

 private:
  FillValues fills_;
  double min_;
  double max_;
  double scale_ = 1.0;
  double offset_ = 0.0;
  std::size_t plausible_ = 0;
  OddValues odd_;
};

// A block of consecutive times as the file has it.
struct RawBlock {
  std::size_t first_time = 0;
  std::size_t times = 0;
  std::vector<std::size_t> count;  // Along each dimension.
  std::vector<double> values;
};

// Values per block: 128 MiB of doubles.
constexpr std::size_t kMaxBlockValues = std::size_t{1} << 24;

// A chunk that holds many times is unpacked once for all of them.
std::size_t TimesPerBlock(const NetcdfFile& file, const FieldAxes& axes,
                          const NetcdfVariable& variable) {
  if (axes.time < 0) return 1;
  const std::size_t chunk =
      file.ChunkLength(variable, static_cast<std::size_t>(axes.time));
  const std::size_t plane = axes.rows_in_file * axes.cols_in_file;
  const std::size_t most = std::max<std::size_t>(
      kMaxBlockValues / std::max<std::size_t>(plane, 1), 1);
  return std::min({chunk, most, axes.times_in_file});
}

RawBlock ReadBlock(const NetcdfFile& file, const FieldAxes& axes,
                   const NetcdfVariable& variable, std::size_t first_time,
                   std::size_t times) {
  RawBlock block;
  block.first_time = first_time;
  block.times = std::min(times, axes.times_in_file - first_time);
  std::vector<std::size_t> start = axes.start;
  block.count.assign(start.size(), 1);
  if (axes.time >= 0) {
    start[axes.time] = first_time;
    block.count[axes.time] = block.times;
  }
  block.count[axes.lat] = axes.rows_in_file;
  block.count[axes.lon] = axes.cols_in_file;
  block.values = file.Values(variable, start, block.count);
  return block;
}

// Distance in the block between neighbours along a dimension.
std::size_t StepAlong(const RawBlock& block, int dimension) {
  std::size_t step = 1;
  for (std::size_t i = block.count.size(); i-- > 0;) {
    if (static_cast<int>(i) == dimension) return step;
    step *= block.count[i];
  }
  return 0;  // The variable has no such dimension.
}

// `time`: which one of the block; `canonical_time`: which one of the axes.
Raster Canonical(const FieldAxes& axes, const RawBlock& block, std::size_t time,
                 std::size_t canonical_time, ValueUnpacker* unpack) {
  const std::size_t row_step = StepAlong(block, axes.lat);
  const std::size_t col_step = StepAlong(block, axes.lon);
  const std::size_t begin = time * StepAlong(block, axes.time);
  Raster raster;
  raster.reserve(axes.grid.size());
  for (const std::size_t row : axes.file_row) {
    for (const std::size_t col : axes.file_col) {
      const bool is_hole = row == kNotInFile || col == kNotInFile;
      raster.push_back(
          is_hole
              ? kNoData
              : (*unpack)(block.values[begin + row * row_step + col * col_step],
                          canonical_time, raster.size()));
    }
  }
  return raster;
}

// "19.5 E, 24 N at 2020-11-01T00:00:00Z"
std::string PlaceText(const FieldAxes& axes, std::size_t time, Cell cell) {
  const LonLat centre = axes.grid.Centre(cell);
  std::ostringstream text;
  text << centre.lon_deg << " E, " << centre.lat_deg << " N";
  if (!std::isnan(axes.time_s[time])) {
    text << " at " << TimeText(axes.time_s[time]);
  }
  return text.str();
}

Cell CellAtIndex(const Grid& grid, std::size_t index) {
  const int at = static_cast<int>(index);
  return {at / grid.cols(), at % grid.cols()};
}

// Rejects a variable that is mostly no such quantity; reports a minority, whose
// cells are without data.
void CheckOddValues(const NetcdfFile& file, const NetcdfVariable& variable,
                    const FieldAxes& axes, const QuantityWords& words,
                    const ValueUnpacker& unpack, VariableReport* report) {
  const OddValues& odd = unpack.odd();
  report->impossible_values = odd.count();
  if (odd.count() == 0) return;
  std::ostringstream range;
  range << words.min_value << " to " << words.max_value << " " << words.unit;
  const std::string found =
      std::to_string(odd.count()) + " values are impossible for " + words.name +
      " (" + range.str() + "), " + odd.Commonest() + ", the first at " +
      PlaceText(axes, odd.first_time(), CellAtIndex(axes.grid, odd.first_at()));
  if (odd.count() > unpack.plausible()) {
    file.Refuse(variable, "most values are impossible for " +
                              std::string(words.name) + ", expected " +
                              range.str() + ", found " + odd.Commonest() +
                              kRemedy);
  }
  report->warnings.push_back(found + ": taken as no data" + kRemedy);
}

// An undeclared fill of a mask or another quantity without limits is refused.
void RefuseUndeclaredFill(const NetcdfFile& file,
                          const NetcdfVariable& variable,
                          const QuantitySeries& series) {
  const std::optional<UndeclaredFill> fill = FindUndeclaredFill(series.at_time);
  if (!fill) return;
  std::ostringstream text;
  text << "value " << fill->value << " is far beyond all others (at most "
       << fill->others
       << "): expected it to be declared by _FillValue or missing_value if it "
          "means no data";
  file.Refuse(variable, text.str());
}

// Reports spikes of a quantity that has none by nature.
void CountOutliers(const FieldAxes& axes, QuantitySeries* series) {
  if (HasSpikes(series->standard_name)) return;
  const OutlierValues found = FindOutliers(axes.grid, series->at_time);
  series->report.outliers = found.count;
  if (found.count == 0) return;
  std::ostringstream text;
  text << found.count << " values are outliers, far from all others and from "
       << "their neighbours, the first " << found.value << " at "
       << PlaceText(axes, found.raster, found.cell)
       << ": they are kept; check the file";
  series->report.warnings.push_back(text.str());
}

std::size_t CellsWithoutData(const QuantitySeries& series) {
  if (series.at_time.empty()) return 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < series.at_time.front().size(); ++i) {
    count += std::all_of(
        series.at_time.begin(), series.at_time.end(),
        [i](const Raster& raster) { return std::isnan(raster[i]); });
  }
  return count;
}

std::string TimesText(const std::vector<double>& time_s) {
  if (std::isnan(time_s.front())) return "";
  std::string text =
      std::to_string(time_s.size()) + (time_s.size() == 1 ? " time" : " times");
  text += ", " + TimeText(time_s.front());
  if (time_s.size() == 1) return text;
  std::ostringstream step;
  step << FindTimeSteps(time_s).usual_s / 3600.0;
  return text + " to " + TimeText(time_s.back()) + ", every " + step.str() +
         " h";
}

bool IsEmpty(const Raster& raster) {
  return std::all_of(raster.begin(), raster.end(),
                     [](float value) { return std::isnan(value); });
}

// A variable of a quantity must have data; a time without any is reported,
// because no window may need it.
void CheckEmptyTimes(const NetcdfFile& file, const NetcdfVariable& variable,
                     const FieldAxes& axes, QuantitySeries* series) {
  std::vector<std::size_t> empty;
  for (std::size_t time = 0; time < series->at_time.size(); ++time) {
    if (IsEmpty(series->at_time[time])) empty.push_back(time);
  }
  if (empty.empty()) return;
  if (empty.size() == series->at_time.size()) {
    file.Refuse(variable, "no value in any cell at any time, expected some");
  }
  series->report.warnings.push_back(
      "no value in any cell at " + std::to_string(empty.size()) + " of " +
      std::to_string(axes.time_s.size()) + " times, the first is " +
      TimeText(axes.time_s[empty.front()]));
}

void CheckGaps(const FieldAxes& axes, VariableReport* report) {
  const TimeSteps steps = FindTimeSteps(axes.time_s);
  if (steps.missing == 0) return;
  report->warnings.push_back(
      std::to_string(steps.missing) + " times are missing, the first between " +
      TimeText(steps.gap_begin_s) + " and " + TimeText(steps.gap_end_s));
}

// Reads in the order of the file, so that each chunk is unpacked once, and
// leaves out times that the axes do not have.
std::vector<Raster> ReadRasters(const NetcdfFile& file, const FieldAxes& axes,
                                const NetcdfVariable& variable,
                                ValueUnpacker* unpack) {
  constexpr std::size_t kLeftOut = static_cast<std::size_t>(-1);
  std::vector<std::size_t> canonical(axes.times_in_file, kLeftOut);
  for (std::size_t i = 0; i < axes.file_time.size(); ++i) {
    canonical[axes.file_time[i]] = i;
  }
  std::vector<Raster> rasters(axes.time_s.size());
  const std::size_t block_times = TimesPerBlock(file, axes, variable);
  for (std::size_t time = 0; time < axes.times_in_file; time += block_times) {
    const RawBlock block = ReadBlock(file, axes, variable, time, block_times);
    for (std::size_t i = 0; i < block.times; ++i) {
      const std::size_t to = canonical[time + i];
      if (to == kLeftOut) continue;
      rasters[to] = Canonical(axes, block, i, to, unpack);
    }
  }
  return rasters;
}

}  // namespace

QuantitySeries ReadSeries(const NetcdfFile& file, const FieldAxes& axes,
                          const NetcdfVariable& variable,
                          FieldQuantity quantity) {
  const QuantityWords words =
      WordsFor(quantity, variable.Text("standard_name"));
  QuantitySeries series;
  series.quantity = quantity;
  series.variable = variable.name;
  series.standard_name = variable.Text("standard_name");
  VariableReport& report = series.report;
  report.quantity = words.name;
  report.variable = variable.name;
  report.level = axes.level;
  report.times = TimesText(axes.time_s);
  report.issue_time_s = axes.issue_time_s;
  report.warnings = axes.warnings;
  ValueUnpacker unpack(file, variable, words, &report);
  series.at_time = ReadRasters(file, axes, variable, &unpack);
  report.cells = axes.grid.size();
  report.cells_without_data = CellsWithoutData(series);
  if (quantity == FieldQuantity::kAny) {
    RefuseUndeclaredFill(file, variable, series);
    return series;
  }
  CheckOddValues(file, variable, axes, words, unpack, &report);
  CheckEmptyTimes(file, variable, axes, &series);
  CheckGaps(axes, &report);
  CountOutliers(axes, &series);
  return series;
}

}  // namespace kg_base
