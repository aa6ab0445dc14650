// Conversion between units as UDUNITS-2 reads them, plus a few spellings that
// files use and UDUNITS does not read.
// Source: https://docs.unidata.ucar.edu/udunits/2.2.28/udunits2lib.html

#ifndef KG_BASE_RASTER_UNIT_CONVERSION_H_
#define KG_BASE_RASTER_UNIT_CONVERSION_H_

#include <optional>
#include <string>

namespace kg_base {

// value in the wanted unit = value * scale + offset.
struct UnitScale {
  double scale = 1.0;
  double offset = 0.0;
};

// Nullopt if `from` is no unit or is not convertible to `to` by a scale and an
// offset. Throws InputError if the database of UDUNITS cannot be read.
// Thread-safe.
std::optional<UnitScale> ConvertUnit(const std::string& from,
                                     const std::string& to);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_UNIT_CONVERSION_H_
