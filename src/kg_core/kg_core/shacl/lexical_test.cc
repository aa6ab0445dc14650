#include "kg_core/shacl/lexical.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "kg_core/rdf/namespaces.h"

namespace kg_core::shacl {
namespace {

TEST(Lexical, FormsFollowXmlSchema) {
  const std::tuple<const char*, const char*, bool> kCases[] = {
      {"2020-02-29", "date", true},
      {"2021-02-29", "date", false},
      {"\u0662\u0660\u0662\u0660-01-01", "date", false},
      {"2020-01-01T24:00:00Z", "dateTime", true},
      {"2020-01-01T00:00:00", "dateTimeStamp", false},
      {"P1Y", "duration", true},
      {"-P1Y2M3DT4H5M6.7S", "duration", true},
      {"PT1S", "duration", true},
      {"P", "duration", false},
      {"P1YT", "duration", false},
      {"PT", "dayTimeDuration", false},
      {"P1D", "dayTimeDuration", true},
      {"P1M", "dayTimeDuration", false},
      {"P", "yearMonthDuration", false},
      {"P1M", "yearMonthDuration", true},
      {"+INF", "double", true},
      {"1.e3", "float", true},
      {"1e", "double", false},
      {"\u0663", "integer", false},
      {"5.", "decimal", true},
      {"1.0", "integer", false},
      {"-9223372036854775808", "long", true},
      {"-9223372036854775809", "long", false},
      {"256", "unsignedByte", false},
      {"a b", "anyURI", false},
      {"0aF0", "hexBinary", true},
      {"0aF", "hexBinary", false},
  };
  kg_base::RegexCache regexes;
  for (const auto& [text, type, expected] : kCases) {
    EXPECT_EQ(IsLexical(Literal(text, kXsd + std::string(type)), regexes),
              expected)
        << text << " " << type;
  }
  EXPECT_TRUE(IsLexical(Literal("x", "http://h/type"), regexes));
}

}  // namespace
}  // namespace kg_core::shacl
