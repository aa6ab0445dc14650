// Joins strings or texts of values with a separator, e.g. names in messages.

#ifndef KG_BASE_COMMON_JOIN_STRINGS_H_
#define KG_BASE_COMMON_JOIN_STRINGS_H_

#include <string>
#include <string_view>
#include <vector>

namespace kg_base {

std::string JoinStrings(const std::vector<std::string>& parts,
                        std::string_view separator = ", ");

// The same of what `to_text` makes of each value.
template <typename Values, typename ToText>
std::string JoinStrings(const Values& values, std::string_view separator,
                        const ToText& to_text) {
  std::vector<std::string> parts;
  for (const auto& value : values) parts.push_back(to_text(value));
  return JoinStrings(parts, separator);
}

}  // namespace kg_base

#endif  // KG_BASE_COMMON_JOIN_STRINGS_H_
