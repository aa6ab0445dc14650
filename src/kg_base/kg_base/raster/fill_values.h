// The values that stand for no data in a variable of a gridded file.
// Source: CF-1.8, section 2.5.1; the NetCDF users' guide.

#ifndef KG_BASE_RASTER_FILL_VALUES_H_
#define KG_BASE_RASTER_FILL_VALUES_H_

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

// Does the type's default fill count? A coordinate may have that value.
enum class DefaultFills { kCount, kDoNotCount };

// _FillValue and missing_value, as number or text, and the type's default.
class FillValues {
 public:
  // Throws InputError for a text that is no number.
  FillValues(const NetcdfFile& file, const NetcdfVariable& variable,
             DefaultFills defaults = DefaultFills::kCount);

  // For raw values, before unpacking. Reals may differ by their precision.
  bool Contains(double raw) const {
    return std::any_of(fills_.begin(), fills_.end(),
                       [&](double fill) { return IsSame(raw, fill); });
  }

 private:
  void Add(const NetcdfVariable& variable, const std::vector<double>& values);
  bool IsSame(double raw, double fill) const;

  bool is_real_;
  std::vector<double> fills_;
};

// A value that programs write where there is no data (-9999, 1e20, ...), if it
// is among the values, far beyond all others; the file does not declare it.
struct UndeclaredFill {
  double value = 0.0;
  double others = 0.0;  // The greatest magnitude of the others.
};
std::optional<UndeclaredFill> FindUndeclaredFill(
    const std::vector<Raster>& rasters);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FILL_VALUES_H_
