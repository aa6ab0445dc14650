// Strings in one, with a separator between them: for names in messages.

#ifndef KG_CORE_BASE_JOIN_STRINGS_H_
#define KG_CORE_BASE_JOIN_STRINGS_H_

#include <string>
#include <string_view>
#include <vector>

namespace kg_core {

std::string JoinStrings(const std::vector<std::string>& parts,
                        std::string_view separator = ", ");

}  // namespace kg_core

#endif  // KG_CORE_BASE_JOIN_STRINGS_H_
