#include "kg_base/raster/coordinate_axis.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "kg_base/raster/steps.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxEntries = 100000;
// A gap above this multiple of the widest spacing is not the seam of a global
// grid.
constexpr double kSeamFactor = 1.5;
// A gap above this multiple of the spacing around it is a hole. Stretched grids
// change from one cell to the next by less.
constexpr double kHoleFactor = 1.7;
constexpr double kSameColumn = 0.01;  // In spacings.
// Rounding of degrees in single precision, beyond a pole or 180 degrees.
constexpr double kSinglePrecision_deg = 1e-4;

void CheckMonotonic(const NetcdfFile& file, const NetcdfVariable& axis,
                    const std::vector<double>& values) {
  if (values.size() < 2) {
    file.Refuse(axis, "expected at least two values, found one");
  }
  const bool descends = values[1] < values[0];
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (descends ? step < 0.0 : step > 0.0) continue;
    file.Refuse(axis,
                "expected values that only ascend or only descend, value " +
                    std::to_string(i) + " does not");
  }
}

CoordinateAxis Ascending(const NetcdfFile& file, const NetcdfVariable& axis,
                         std::vector<double> values) {
  CheckMonotonic(file, axis, values);
  CoordinateAxis ascending;
  ascending.in_file.resize(values.size());
  std::iota(ascending.in_file.begin(), ascending.in_file.end(), std::size_t{0});
  if (values[1] < values[0]) {
    std::reverse(values.begin(), values.end());
    std::reverse(ascending.in_file.begin(), ascending.in_file.end());
  }
  ascending.centres_deg = std::move(values);
  return ascending;
}

// The spacing that a gap is compared with: that beside it, but at least the
// usual one, so that one narrow cell makes no holes of its neighbours.
double SpacingAt(const std::vector<double>& gaps, std::size_t i, double usual) {
  double beside = i > 0 ? gaps[i - 1] : gaps[i + 1];
  if (i > 0 && i + 1 < gaps.size()) beside = std::min(beside, gaps[i + 1]);
  return std::max(beside, usual);
}

// Three values or fewer have no usual spacing that would show a hole.
void FillHoles(const NetcdfFile& file, const NetcdfVariable& variable,
               CoordinateAxis* axis) {
  const std::vector<double> gaps = StepsBetween(axis->centres_deg);
  if (gaps.size() < 3) return;
  const double usual = LowerMedian(gaps);
  CoordinateAxis filled;
  filled.warnings = axis->warnings;
  for (std::size_t i = 0; i < axis->centres_deg.size(); ++i) {
    filled.centres_deg.push_back(axis->centres_deg[i]);
    filled.in_file.push_back(axis->in_file[i]);
    if (i >= gaps.size()) break;
    const double spacing = SpacingAt(gaps, i, usual);
    if (!(gaps[i] > kHoleFactor * spacing)) continue;
    const double parts = std::round(gaps[i] / spacing);
    if (!(parts + static_cast<double>(filled.centres_deg.size()) <
          kMaxEntries)) {
      file.Refuse(variable, "expected values that are evenly spaced, value " +
                                std::to_string(i + 1) + " is far off");
    }
    for (int part = 1; part < parts; ++part) {
      filled.centres_deg.push_back(axis->centres_deg[i] +
                                   gaps[i] * part / parts);
      filled.in_file.push_back(kNotInFile);
    }
    filled.warnings.push_back(variable.name + " has a hole from " +
                              std::to_string(axis->centres_deg[i]) + " to " +
                              std::to_string(axis->centres_deg[i + 1]) +
                              " degrees: its cells are without data");
  }
  *axis = std::move(filled);
}

// Longitudes that fall or rise by more than half a turn pass the end of their
// range there: 179, -180 or 0, 359.
std::vector<double> Unwrapped(std::vector<double> values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (std::abs(step) > 180.0) values[i] -= 360.0 * std::round(step / 360.0);
  }
  return values;
}

bool IsMonotonic(const std::vector<double>& values) {
  return std::is_sorted(values.begin(), values.end()) ||
         std::is_sorted(values.rbegin(), values.rend());
}

// Drops columns that repeat others a turn later, as plotting tools add them.
void DropRepeatedColumns(const NetcdfVariable& variable, CoordinateAxis* axis) {
  std::vector<double>& lon = axis->centres_deg;
  std::size_t repeated = 0;
  while (lon.size() > 3) {
    const double tolerance = kSameColumn * (lon[1] - lon[0]);
    const double turned = lon.back() - 360.0;
    const auto nearest =
        std::lower_bound(lon.begin(), lon.end(), turned - tolerance);
    if (nearest == lon.end() || *nearest > turned + tolerance) break;
    lon.pop_back();
    axis->in_file.pop_back();
    ++repeated;
  }
  if (repeated == 0) return;
  axis->warnings.push_back(variable.name + ": " + std::to_string(repeated) +
                           " repeated columns at its end are left out");
}

// The longitudes of a region that touches 180 degrees, from its western end in
// [-180, 180) on. Throws InputError if it lies on both sides.
std::vector<double> UpToSeam(const NetcdfFile& file, const NetcdfVariable& axis,
                             const std::vector<double>& ascending,
                             double western) {
  std::vector<double> shifted = ascending;
  for (double& lon : shifted) lon += western - ascending.front();
  if (shifted.back() <= 180.0 + kSinglePrecision_deg) {
    shifted.back() = std::min(shifted.back(), 180.0);
    return shifted;
  }
  std::ostringstream text;
  text << "the grid crosses the antimeridian (longitudes " << ascending.front()
       << " to " << ascending.back()
       << "), expected one on one side of 180 degrees; cut it there, for "
          "example with cdo sellonlatbox,"
       << shifted.front() << ",180,-90,90";
  file.Refuse(axis, text.str());
}

// Wraps each longitude into [-180, 180). A file that crosses 180 degrees must
// be global, i.e. its ends must meet.
std::vector<double> Wrapped(const NetcdfFile& file, const NetcdfVariable& axis,
                            const std::vector<double>& ascending) {
  std::vector<double> wrapped;
  double widest = 0.0;
  std::size_t seams = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const double lon = ascending[i];
    wrapped.push_back(lon - 360.0 * std::floor((lon + 180.0) / 360.0));
    if (i == 0) continue;
    widest = std::max(widest, lon - ascending[i - 1]);
    seams += wrapped[i] < wrapped[i - 1];  // Passed 180 degrees.
  }
  // From the last column around the globe to the first: a normal spacing in a
  // global file, the rest of the globe in a regional one.
  const double gap = ascending.front() + 360.0 - ascending.back();
  if (seams == 0 || gap <= kSeamFactor * widest) return wrapped;
  return UpToSeam(file, axis, ascending, wrapped.front());
}

void CheckSpan(const NetcdfFile& file, const NetcdfVariable& axis,
               const std::vector<double>& ascending) {
  // Values beyond two turns: not longitudes.
  const double west = ascending.front();
  const double east = ascending.back();
  if (west >= -360.0 && east <= 720.0 && east - west < 360.0) return;
  file.Refuse(axis, "expected degrees that span less than a turn, found " +
                        std::to_string(west) + " to " + std::to_string(east));
}

}  // namespace

CoordinateAxis LatitudeAxis(const NetcdfFile& file, const NetcdfVariable& axis,
                            std::vector<double> values) {
  CoordinateAxis latitudes = Ascending(file, axis, std::move(values));
  std::vector<double>& lat = latitudes.centres_deg;
  if (lat.front() < -90.0 - kSinglePrecision_deg ||
      lat.back() > 90.0 + kSinglePrecision_deg) {
    file.Refuse(axis, "expected degrees from -90 to 90");
  }
  lat.front() = std::max(lat.front(), -90.0);
  lat.back() = std::min(lat.back(), 90.0);
  FillHoles(file, axis, &latitudes);
  return latitudes;
}

CoordinateAxis LongitudeAxis(const NetcdfFile& file, const NetcdfVariable& axis,
                             std::vector<double> values) {
  // Step 1: ascending from west to east.
  if (!IsMonotonic(values)) values = Unwrapped(std::move(values));
  CoordinateAxis longitudes = Ascending(file, axis, std::move(values));
  DropRepeatedColumns(axis, &longitudes);
  CheckSpan(file, axis, longitudes.centres_deg);
  // Step 2: into [-180, 180), beginning with the westernmost column. A global
  // file from 0 to 360 is split at 180 and its halves are swapped.
  std::vector<double> wrapped = Wrapped(file, axis, longitudes.centres_deg);
  const auto turn =
      std::min_element(wrapped.begin(), wrapped.end()) - wrapped.begin();
  std::rotate(wrapped.begin(), wrapped.begin() + turn, wrapped.end());
  std::rotate(longitudes.in_file.begin(), longitudes.in_file.begin() + turn,
              longitudes.in_file.end());
  longitudes.centres_deg = std::move(wrapped);
  // Step 3: a region across 180 degrees that was sorted has a hole here.
  FillHoles(file, axis, &longitudes);
  return longitudes;
}

}  // namespace kg_base
