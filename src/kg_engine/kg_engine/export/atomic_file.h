// Atomic file writes.

#ifndef KG_ENGINE_EXPORT_ATOMIC_FILE_H_
#define KG_ENGINE_EXPORT_ATOMIC_FILE_H_

#include <string>
#include <string_view>

#include "absl/functional/function_ref.h"

namespace kg_engine {

// `write` writes a temporary file next to `path`, which is then renamed to
// `path`; on failure nothing is left and `path` is unchanged. `path` must be
// absolute. Throws kg_base::InputError in one line.
void WriteAtomically(const std::string& path,
                     absl::FunctionRef<void(const std::string& path)> write);
void WriteAtomically(const std::string& path, std::string_view text);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_ATOMIC_FILE_H_
