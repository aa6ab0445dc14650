#include "kg_base/common/one_line.h"

namespace kg_base {

std::string OneLine(const std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace kg_base
