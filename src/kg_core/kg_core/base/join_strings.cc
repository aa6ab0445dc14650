#include "kg_core/base/join_strings.h"

#include "absl/strings/str_join.h"

namespace kg_core {

std::string JoinStrings(const std::vector<std::string>& parts,
                        const std::string_view separator) {
  return absl::StrJoin(parts,
                       absl::string_view(separator.data(), separator.size()));
}

}  // namespace kg_core
