// Longitudes and latitudes of a file as the ascending axes of a grid, and where
// the file has each of them.

#ifndef KG_BASE_RASTER_COORDINATE_AXIS_H_
#define KG_BASE_RASTER_COORDINATE_AXIS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

// Index of an entry that the file does not have: a hole.
inline constexpr std::size_t kNotInFile = static_cast<std::size_t>(-1);

struct CoordinateAxis {
  std::vector<double> centres_deg;   // Ascending.
  std::vector<std::size_t> in_file;  // Index in the file, or kNotInFile.
  std::vector<std::string> warnings;
};

// `values`: unpacked, in the order of the file. Both throw InputError if they
// are no coordinates, do not run one way, or if longitudes cross 180 degrees
// other than around the whole globe. Entries are added where neighbours are
// further apart than the rest, so that tiles with a hole between them become
// one grid with cells without data. A column that is there again a turn later
// is dropped.
CoordinateAxis LatitudeAxis(const NetcdfFile& file, const NetcdfVariable& axis,
                            std::vector<double> values);
CoordinateAxis LongitudeAxis(const NetcdfFile& file, const NetcdfVariable& axis,
                             std::vector<double> values);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_COORDINATE_AXIS_H_
