#include "kg_core/sparql/fresh_blank.h"

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

namespace kg_core::sparql {
namespace {

std::string ProcessPrefix() {
  std::random_device device;
  std::string prefix = "q";
  for (int i = 0; i < 3; ++i) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", device());
    prefix += digits;
  }
  return prefix + "x";
}

}  // namespace

Term FreshBlank() {
  static const std::string* const prefix = new std::string(ProcessPrefix());
  static std::atomic<std::uint64_t> count{0};
  return Blank(*prefix + std::to_string(++count));
}

}  // namespace kg_core::sparql
