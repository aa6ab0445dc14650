#include "kg_base/text/utf8.h"

#include <gtest/gtest.h>

#include <utility>

namespace kg_base {
namespace {

TEST(Utf8, MapsCaseByUnicode) {
  const std::pair<const char*, const char*> kUpper[] = {
      {"", ""},
      {"abc-1", "ABC-1"},
      {"\u00FF", "\u0178"},
      {"stra\u00DFe", "STRASSE"},
      {"\uFB01", "FI"},
      {"\u0149", "\u02BCN"},
      {"\u03AC\u03C2", "\u0386\u03A3"},
      {"\u0561", "\u0531"},
      {"\u0493", "\u0492"},
      {"\u10D0", "\u1C90"},
      {"\U00010428", "\U00010400"},
      {"i\u0131", "II"},
  };
  for (const auto& [text, upper] : kUpper) EXPECT_EQ(UpperCase(text), upper);
  const std::pair<const char*, const char*> kLower[] = {
      {"ABC-1", "abc-1"},
      {"\u038C", "\u03CC"},
      {"\u1EA4", "\u1EA5"},
      {"\uFF21", "\uFF41"},
      {"\u0130", "i\u0307"},
      {"\u1E9E", "\u00DF"},
      {"\u039F\u03A3", "\u03BF\u03C2"},
      {"\u2C00", "\u2C30"},
      {"\U00010400", "\U00010428"},
      {"I", "i"},
  };
  for (const auto& [text, lower] : kLower) EXPECT_EQ(LowerCase(text), lower);
}

TEST(Utf8, CaseMappingKeepsTextWithZeros) {
  EXPECT_EQ(UpperCase(std::string_view("a\0b", 3)),
            std::string_view("A\0B", 3));
}

}  // namespace
}  // namespace kg_base
