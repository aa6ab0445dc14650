// Reads the fields of an ocean model file (NetCDF classic or 4) into canonical
// form. CF attributes decide first, names second; what is not understood is
// refused with one line that names file, variable and expectation.
//
// Understood: packed (scale_factor, add_offset) or float, _FillValue and
// missing_value and NaN, any usual time unit ("hours since ...", also
// calendars standard/gregorian/proleptic_gregorian), with or without a depth
// dimension (the shallowest level is taken), dimension orders of (time),
// (depth), lat, lon in any order, longitudes 0..360 or -180..180, latitudes up
// or down, uneven spacing. `valid_range` is not a mask. A classic file that is
// shorter than its header promises is refused (the library would read zeros).
//
// A quantity without `units` is in SI (degree Celsius). Values that cannot be
// (beyond 10 m/s, outside -5..60 degree Celsius) are no data; a variable where
// most are like that, or a time step without any data, is refused. So are
// curvilinear grids, grids across the antimeridian, times that do not ascend.
// Source of the conventions: CF-1.8, sections 2.5.1, 4.1-4.4, 8.1.

#ifndef KG_CORE_RASTER_OCEAN_FILE_H_
#define KG_CORE_RASTER_OCEAN_FILE_H_

#include <string>
#include <vector>

#include "kg_core/raster/grid.h"

namespace kg_core {

// What can be asked of a file, and the CF standard names (first) and variable
// names (second) that provide it.
enum class Quantity {
  kEastwardVelocity,   // m/s; eastward_sea_water_velocity; water_u, u
  kNorthwardVelocity,  // m/s; northward_sea_water_velocity; water_v, v
  kTemperature,  // degree Celsius; sea_surface_temperature, ...; water_temp
  kAny,          // A variable asked for by its own name, in its own unit.
};
const char* Name(Quantity quantity);  // "eastward velocity", ...

struct QuantitySeries {
  Quantity quantity = Quantity::kTemperature;
  std::string variable;         // Its name in the file.
  std::vector<Raster> at_time;  // One raster for each time of the file.
};

struct OceanFile {
  std::string path;
  std::string sha256;  // Of the whole file.
  Grid grid;
  // Unix seconds, strictly ascending; one NaN for a variable without time.
  std::vector<double> time_s;
  std::vector<QuantitySeries> series;  // In the order asked for.
};

// Throws InputError, also when a quantity is missing.
OceanFile ReadOceanFile(const std::string& path,
                        const std::vector<Quantity>& quantities);

// One variable by its name, whatever it is: a mask, a map of habitats. Packing
// and fill values are taken away, units are not looked at, any finite value is
// a value, a step may be empty, and there may be no time. Throws InputError.
OceanFile ReadVariable(const std::string& path, const std::string& variable);

// Both in a child process (program "read_ocean_file" of this package, found
// beside the running program) that is ended after `deadline_s`: damaged
// NetCDF-4 files can hang or crash the library. Throws InputError then, too.
OceanFile ReadOceanFileSafely(const std::string& path,
                              const std::vector<Quantity>& quantities,
                              double deadline_s = 30.0);
OceanFile ReadVariableSafely(const std::string& path,
                             const std::string& variable,
                             double deadline_s = 30.0);

}  // namespace kg_core

#endif  // KG_CORE_RASTER_OCEAN_FILE_H_
