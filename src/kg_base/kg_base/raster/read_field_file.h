// Reads the fields of an ocean or weather model's file (NetCDF classic or 4)
// into canonical form. CF attributes take precedence over names; unsupported
// input is rejected with one line that names file, variable and expectation.
//
// Supported: all groups of a file; packed (scale_factor, add_offset,
// _Unsigned) or float, _FillValue and missing_value and NaN, any unit that
// UDUNITS reads, calendars standard/gregorian/proleptic_gregorian, dimension
// orders of (time), (level), lat, lon in any order, longitudes 0..360 or
// -180..180 or beginning anywhere, with a repeated column or not, latitudes up
// or down, uneven spacing, coordinates with two dimensions of a regular grid.
// `valid_range` is not a mask. A classic file that is shorter than its header
// states is rejected (the library would read zeros).
//
// Times are those when values hold, for periods their middles (field_times.h).
// The level is the surface (vertical_axis.h). Holes between tiles become cells
// without data (coordinate_axis.h).
//
// A quantity without `units` is in SI (degree Celsius). Values outside the
// valid range (sea: 10 m/s, -5..60 degree Celsius; wind: 120 m/s; air:
// -100..100 degree Celsius; ground surface: -100..2000 degree Celsius) are no
// data; a variable where most are outside, or without any data, is rejected. So
// are curvilinear and rotated grids, grids across the antimeridian, times that
// do not ascend, and one component of the sea with one of the wind. If a file
// has the quantity both of the sea and of another medium, that of the sea is
// read. Choices are reported (QuantitySeries::report). Source of the
// conventions: CF-1.8, sections 2.5.1, 4.1-4.4, 7.1, 7.3, 8.1.

#ifndef KG_BASE_RASTER_READ_FIELD_FILE_H_
#define KG_BASE_RASTER_READ_FIELD_FILE_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"

namespace kg_base {

// Throws InputError, also when a quantity is missing.
FieldFile ReadFieldFile(const std::string& path,
                        const std::vector<FieldQuantity>& quantities);

// Reads any variable by its name, e.g. a mask or a map of habitats. Values are
// unpacked and fill values removed; units are ignored, any finite value is
// valid but an undeclared fill, a step may be empty, and time is optional.
// Throws InputError.
FieldFile ReadVariable(const std::string& path, const std::string& variable);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_READ_FIELD_FILE_H_
