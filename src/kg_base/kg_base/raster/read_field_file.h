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

#ifndef KG_BASE_RASTER_READ_FIELD_FILE_H_
#define KG_BASE_RASTER_READ_FIELD_FILE_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"

namespace kg_base {

// Throws InputError, also when a quantity is missing.
FieldFile ReadFieldFile(const std::string& path,
                        const std::vector<FieldQuantity>& quantities);

// One variable by its name, whatever it is: a mask, a map of habitats. Packing
// and fill values are taken away, units are not looked at, any finite value is
// a value, a step may be empty, and there may be no time. Throws InputError.
FieldFile ReadVariable(const std::string& path, const std::string& variable);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_READ_FIELD_FILE_H_
