#include "kg_base/common/input_error.h"

#include <gtest/gtest.h>

#include <string>

namespace kg_base {
namespace {

TEST(InputError, IsOneLineWhateverItQuotes) {
  const InputError error("file \"a\nb\r\tc\x7f\": expected one");
  EXPECT_EQ(std::string(error.what()), "file \"a b  c \": expected one");
}

}  // namespace
}  // namespace kg_base
