// Files that are there whole or not at all.

#ifndef KG_ENGINE_EXPORT_ATOMIC_FILE_H_
#define KG_ENGINE_EXPORT_ATOMIC_FILE_H_

#include <string>
#include <string_view>

#include "absl/functional/function_ref.h"

namespace kg_engine {

// `write` makes a temporary file beside `path`, which is then renamed to it; if
// anything fails nothing is left and `path` is what it was. `path` must be
// absolute. Throws kg_base::InputError in one line.
void WriteAtomically(const std::string& path,
                     absl::FunctionRef<void(const std::string& path)> write);
void WriteAtomically(const std::string& path, std::string_view text);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_ATOMIC_FILE_H_
