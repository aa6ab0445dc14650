// Strings in one, with a separator between them: for names in messages.

#ifndef KG_BASE_COMMON_JOIN_STRINGS_H_
#define KG_BASE_COMMON_JOIN_STRINGS_H_

#include <string>
#include <string_view>
#include <vector>

namespace kg_base {

std::string JoinStrings(const std::vector<std::string>& parts,
                        std::string_view separator = ", ");

}  // namespace kg_base

#endif  // KG_BASE_COMMON_JOIN_STRINGS_H_
