#include "kg_base/common/text.h"

#include <algorithm>
#include <fstream>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"

namespace kg_base {
namespace {

TEST(Text, EveryScalarIsWellFormedAndNoSurrogateIs) {
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    std::string text;
    AppendUtf8(code, &text);
    ASSERT_EQ(!FirstBadUtf8(text), IsUnicodeScalar(code)) << code;
    if (!IsUnicodeScalar(code)) continue;
    ASSERT_EQ(text.size(), code < 0x80      ? 1u
                           : code < 0x800   ? 2u
                           : code < 0x10000 ? 3u
                                            : 4u);
  }
  EXPECT_FALSE(IsUnicodeScalar(0x110000));
}

// Only encodings of scalars are well-formed: the number of valid sequences of
// one, two and three bytes equals the number of scalars of that length.
TEST(Text, NothingElseIsWellFormed) {
  int single = 0, pairs = 0, triples = 0;
  const auto byte = [](int value) { return static_cast<char>(value); };
  for (int a = 0; a < 256; ++a) {
    single += !FirstBadUtf8(std::string{byte(a)});
    for (int b = 0x80; b < 256; ++b) {
      pairs += a >= 0x80 && !FirstBadUtf8(std::string{byte(a), byte(b)});
      for (int c = 0x80; c < 0xC0 && a >= 0xE0; ++c) {
        triples += !FirstBadUtf8(std::string{byte(a), byte(b), byte(c)});
      }
    }
  }
  EXPECT_EQ(single, 0x80);
  EXPECT_EQ(pairs, 0x800 - 0x80);
  EXPECT_EQ(triples, 0x10000 - 0x800 - 0x800);
}

TEST(Text, FindsTheFirstBadByte) {
  EXPECT_EQ(FirstBadUtf8("ab\xFFz\xFF"), 2u);
  EXPECT_EQ(FirstBadUtf8("\xC3\xA9\xE2\x82"), 2u);
  EXPECT_EQ(FirstBadUtf8("\xF4\x90\x80\x80"), 0u);
  EXPECT_FALSE(FirstBadUtf8(""));
}

TEST(Text, CountsLinesAndColumnsFromOne) {
  const auto at = [](std::string_view text, std::size_t offset) {
    const TextPosition place = PositionAt(text, offset);
    return std::make_pair(place.line, place.column);
  };
  using Place = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(at("", 0), Place(1, 1));
  EXPECT_EQ(at("ab\ncd", 1), Place(1, 2));
  EXPECT_EQ(at("ab\ncd", 2), Place(1, 3));
  EXPECT_EQ(at("ab\ncd", 3), Place(2, 1));
  EXPECT_EQ(at("ab\n\ncd", 6), Place(3, 3));
}

TEST(Text, StripsAndLowersAsciiOnly) {
  EXPECT_EQ(StripAsciiSpace(" \t\r\n a b \n"), "a b");
  EXPECT_EQ(StripAsciiSpace(" \n"), "");
  EXPECT_EQ(ToLowerAscii("EN-gB\xC3\x89[Z"), "en-gb\xC3\x89[z");
}

TEST(Text, ShortensBetweenCharacters) {
  const std::string text = "a\xC3\xA9\xE2\x80\x9C\xF0\x9F\x98\x80z";
  for (std::size_t bytes = 0; bytes <= text.size() + 1; ++bytes) {
    const std::string_view first = FirstCharacters(text, bytes);
    EXPECT_FALSE(FirstBadUtf8(first)) << bytes;
    EXPECT_EQ(text.rfind(first, 0), 0u);
    EXPECT_LE(first.size(), bytes);
    EXPECT_GT(first.size() + 4, std::min(bytes, text.size()));
  }
  EXPECT_EQ(FirstCharacters(text, 100), text);
  EXPECT_EQ(FirstCharacters(text, 5), "a\xC3\xA9");
}

TEST(Text, ReadsFilesUpToTheLimit) {
  const TemporaryFolder folder;
  const std::string path = folder / "text";
  std::ofstream(path, std::ios::binary) << std::string(100000, 'x');
  EXPECT_EQ(ReadFile(path, 100000), std::string(100000, 'x'));
  EXPECT_THROW(ReadFile(path, 99999), InputError);
  EXPECT_THROW(ReadFile(folder / "none", 10), InputError);
  EXPECT_THROW(ReadFile(folder / "", 10), InputError);
}

}  // namespace
}  // namespace kg_base
