// Protocol by which a child process sends a gridded file's contents, or its
// error line, to its parent: a fixed header with all sizes, then the numbers in
// host byte order.

#ifndef KG_BASE_RASTER_FIELD_PROTOCOL_H_
#define KG_BASE_RASTER_FIELD_PROTOCOL_H_

#include <cstddef>
#include <functional>
#include <string>

#include "kg_base/raster/field_file.h"

namespace kg_base {

// Prefix of a variable's name in the arguments of that process, where otherwise
// the number of a quantity is expected.
inline constexpr char kVariableArgument[] = "variable=";

// Limit of the values of all series of a file: 1 GiB of floats.
inline constexpr std::size_t kMaxFieldValues = std::size_t{1} << 28;

using PutBytes = std::function<void(const void* bytes, std::size_t count)>;
// Fills exactly `count` bytes or throws InputError.
using GetBytes = std::function<void(void* bytes, std::size_t count)>;

void WriteFieldFile(const FieldFile& file, const PutBytes& put);
void WriteFieldError(const std::string& line, const PutBytes& put);

// Throws InputError with the error line received, or with the defect of the
// bytes. Implausible sizes are rejected before allocation, and rasters are
// allocated only as their bytes arrive. `path` is used in the result and
// errors.
FieldFile ReadFieldBytes(const std::string& path, const GetBytes& get);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_PROTOCOL_H_
