// The length of a classic NetCDF file (CDF-1, -2, -5) according to its header.
// The library reads zeros beyond the end of a truncated file, which unpacking
// turns into plausible values; so a file shorter than this length is rejected.
// Source: The NetCDF Classic Format Specification (netcdf-c,
// file_format_specs).

#ifndef KG_BASE_RASTER_CLASSIC_LENGTH_H_
#define KG_BASE_RASTER_CLASSIC_LENGTH_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kg_base {

// Bytes up to the end of the last value, without padding after it. `header`:
// the file from its beginning, at least the whole header. Throws InputError
// (without a file name) for a truncated or inconsistent header; nullopt if
// these are not the first bytes of a classic file.
std::optional<std::uint64_t> ClassicLength(std::string_view header);

// Throws InputError that names the file if it is a classic file shorter than
// its header states.
void CheckClassicLength(const std::string& path);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_CLASSIC_LENGTH_H_
