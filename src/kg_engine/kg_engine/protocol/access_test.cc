#include "kg_engine/protocol/access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"

namespace kg_engine {
namespace {

using kg_base::InputError;

class TokenFile : public testing::Test {
 protected:
  std::string Write(const std::string& text, mode_t mode) {
    const std::string path = folder_ / "token";
    std::ofstream(path, std::ios::binary) << text;
    EXPECT_EQ(chmod(path.c_str(), mode), 0);
    return path;
  }
  kg_base::TemporaryFolder folder_;
};

TEST_F(TokenFile, IsItsOneLine) {
  EXPECT_EQ(ReadTokenFile(Write("0123456789abcdef\n", 0600)),
            "0123456789abcdef");
  EXPECT_EQ(ReadTokenFile(Write("0123456789abcdef", 0640)), "0123456789abcdef");
}

TEST_F(TokenFile, IsRefusedIfOthersCanReadOrWriteIt) {
  for (const mode_t mode : {0644, 0604, 0602, 0666}) {
    EXPECT_THROW(ReadTokenFile(Write("0123456789abcdef\n", mode)), InputError)
        << mode;
  }
}

TEST_F(TokenFile, IsRefusedIfItHoldsNoToken) {
  for (const std::string& text :
       {std::string(), std::string("\n"), std::string("short"),
        std::string("0123456789\nabcdef0"), std::string("0123456789 abcdef0"),
        std::string("0123456789\0abcdef", 17), std::string(513, 'x'),
        std::string(5000, 'x'),
        std::string("0123456789\xC3\xA4"
                    "bcdef")}) {
    EXPECT_THROW(ReadTokenFile(Write(text, 0600)), InputError) << text;
  }
  EXPECT_THROW(ReadTokenFile(folder_ / "none"), InputError);
  EXPECT_THROW(ReadTokenFile(folder_ / ""), InputError);
}

}  // namespace
}  // namespace kg_engine
