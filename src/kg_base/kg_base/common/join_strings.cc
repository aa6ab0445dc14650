#include "kg_base/common/join_strings.h"

#include "absl/strings/str_join.h"

namespace kg_base {

std::string JoinStrings(const std::vector<std::string>& parts,
                        const std::string_view separator) {
  return absl::StrJoin(parts,
                       absl::string_view(separator.data(), separator.size()));
}

}  // namespace kg_base
