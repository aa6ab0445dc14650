#include "kg_core/base/one_line.h"

namespace kg_core {

std::string OneLine(const std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace kg_core
