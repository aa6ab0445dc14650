// Reads the fields of an ocean or weather model's file (NetCDF classic or 4)
// into canonical form. CF attributes decide first, names second; what is not
// understood is refused with one line that names file, variable and
// expectation.
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
// (of the sea beyond 10 m/s and outside -5..60 degree Celsius; winds beyond 120
// m/s, air outside -100..100, the ground's surface outside -100..2000) are no
// data; a variable where most are like that, or a time step without any data,
// is refused. So are curvilinear grids, grids across the antimeridian, times
// that do not ascend, and one component of the sea with one of the wind. Where
// a file has the quantity of the sea and of elsewhere, the sea's is taken.
// Source of the conventions: CF-1.8, sections 2.5.1, 4.1-4.4, 8.1.

#ifndef KG_CORE_RASTER_FIELD_FILE_H_
#define KG_CORE_RASTER_FIELD_FILE_H_

#include <string>
#include <vector>

#include "kg_core/raster/grid.h"

namespace kg_core {

// What can be asked of a file, and the CF standard names (first) and variable
// names (second) that provide it.
enum class FieldQuantity {
  // m/s; eastward_sea_water_velocity, ..., eastward_wind; water_u, u
  kEastwardVelocity,
  // m/s; northward_sea_water_velocity, ..., northward_wind; water_v, v
  kNorthwardVelocity,
  // degree Celsius; sea_surface_temperature, ..., surface_temperature,
  // air_temperature; water_temp
  kTemperature,
  // m; sea_surface_wave_significant_height; swh, hs
  kWaveHeight,
  kAny,  // A variable asked for by its own name, in its own unit.
};
const char* Name(FieldQuantity quantity);  // "eastward velocity", ...

struct QuantitySeries {
  FieldQuantity quantity = FieldQuantity::kTemperature;
  std::string variable;         // Its name in the file.
  std::string standard_name;    // Empty if it has none.
  std::vector<Raster> at_time;  // One raster for each time of the file.
};

bool IsWind(const QuantitySeries& series);

struct FieldFile {
  std::string path;
  std::string sha256;  // Of the whole file.
  Grid grid;
  // Unix seconds, strictly ascending; one NaN for a variable without time.
  std::vector<double> time_s;
  std::vector<QuantitySeries> series;  // In the order asked for.
};

// Throws InputError, also when a quantity is missing.
FieldFile ReadFieldFile(const std::string& path,
                        const std::vector<FieldQuantity>& quantities);

// One variable by its name, whatever it is: a mask, a map of habitats. Packing
// and fill values are taken away, units are not looked at, any finite value is
// a value, a step may be empty, and there may be no time. Throws InputError.
FieldFile ReadVariable(const std::string& path, const std::string& variable);

// Both in a child process (program "read_field_file" of this package, found
// beside the running program) that is ended after `deadline_s`: damaged
// NetCDF-4 files can hang or crash the library. Throws InputError then, too.
FieldFile ReadFieldFileSafely(const std::string& path,
                              const std::vector<FieldQuantity>& quantities,
                              double deadline_s = 30.0);
FieldFile ReadVariableSafely(const std::string& path,
                             const std::string& variable,
                             double deadline_s = 30.0);

}  // namespace kg_core

#endif  // KG_CORE_RASTER_FIELD_FILE_H_
