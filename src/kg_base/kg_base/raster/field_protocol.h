// How a child process hands a gridded file's contents, or its error line, to
// its parent: a fixed head with all sizes, then the numbers as both hold them.

#ifndef KG_BASE_RASTER_FIELD_PROTOCOL_H_
#define KG_BASE_RASTER_FIELD_PROTOCOL_H_

#include <cstddef>
#include <functional>
#include <string>

#include "kg_base/raster/field_file.h"

namespace kg_base {

// What stands before a variable's name where a quantity's number could stand,
// in the arguments of that process.
inline constexpr char kVariableArgument[] = "variable=";

// Of all series of a file together: 1 GiB of floats.
inline constexpr std::size_t kMaxFieldValues = std::size_t{1} << 28;

using PutBytes = std::function<void(const void* bytes, std::size_t count)>;
// Fills exactly `count` bytes or throws InputError.
using GetBytes = std::function<void(void* bytes, std::size_t count)>;

void WriteFieldFile(const FieldFile& file, const PutBytes& put);
void WriteFieldError(const std::string& line, const PutBytes& put);

// Throws InputError: the error line that was sent, or what is wrong with the
// bytes. Nothing is allocated for sizes that are not believable, and rasters
// only as their bytes arrive. `path` goes into the result and the errors.
FieldFile ReadFieldBytes(const std::string& path, const GetBytes& get);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_PROTOCOL_H_
