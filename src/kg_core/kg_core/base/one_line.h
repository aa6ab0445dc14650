// Text that fits on one line of a log.

#ifndef KG_CORE_BASE_ONE_LINE_H_
#define KG_CORE_BASE_ONE_LINE_H_

#include <string>
#include <string_view>

namespace kg_core {

// The text with blanks in place of control characters.
std::string OneLine(std::string_view text);

}  // namespace kg_core

#endif  // KG_CORE_BASE_ONE_LINE_H_
