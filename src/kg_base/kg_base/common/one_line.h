// Text that fits on one line of a log.

#ifndef KG_BASE_COMMON_ONE_LINE_H_
#define KG_BASE_COMMON_ONE_LINE_H_

#include <string>
#include <string_view>

namespace kg_base {

// Replaces control characters by spaces.
std::string OneLine(std::string_view text);

}  // namespace kg_base

#endif  // KG_BASE_COMMON_ONE_LINE_H_
