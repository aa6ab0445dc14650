// The length that the header of a classic NetCDF file (CDF-1, -2, -5) promises.
// The library reads zeros where a truncated file ends, which packing turns into
// plausible values; so a file shorter than its promise is no file.
// Source: The NetCDF Classic Format Specification (netcdf-c,
// file_format_specs).

#ifndef KG_BASE_RASTER_CLASSIC_LENGTH_H_
#define KG_BASE_RASTER_CLASSIC_LENGTH_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kg_base {

// Bytes up to the end of the last value, without padding behind it. `header`:
// the file from its beginning, at least the whole header. Throws InputError
// (without a file name) for a header that is cut or makes no sense; nothing
// when these are not the first bytes of a classic file.
std::optional<std::uint64_t> ClassicLength(std::string_view header);

// Throws InputError that names the file when it is a classic one and shorter
// than it promises.
void CheckClassicLength(const std::string& path);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_CLASSIC_LENGTH_H_
