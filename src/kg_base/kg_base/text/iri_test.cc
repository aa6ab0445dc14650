#include "kg_base/text/iri.h"

#include <gtest/gtest.h>

#include <utility>

namespace kg_base {
namespace {

// https://www.rfc-editor.org/rfc/rfc3986#section-5.4
TEST(Iri, ResolvesTheExamplesOfTheStandard) {
  const std::pair<const char*, const char*> kExamples[] = {
      {"g:h", "g:h"},
      {"g", "http://a/b/c/g"},
      {"./g", "http://a/b/c/g"},
      {"g/", "http://a/b/c/g/"},
      {"/g", "http://a/g"},
      {"//g", "http://g"},
      {"?y", "http://a/b/c/d;p?y"},
      {"g?y", "http://a/b/c/g?y"},
      {"#s", "http://a/b/c/d;p?q#s"},
      {"g#s", "http://a/b/c/g#s"},
      {";x", "http://a/b/c/;x"},
      {"", "http://a/b/c/d;p?q"},
      {".", "http://a/b/c/"},
      {"..", "http://a/b/"},
      {"../g", "http://a/b/g"},
      {"../..", "http://a/"},
      {"../../../g", "http://a/g"},
      {"/./g", "http://a/g"},
      {"g..", "http://a/b/c/g.."},
      {"./g/.", "http://a/b/c/g/"},
      {"g/../h", "http://a/b/c/h"},
  };
  for (const auto& [reference, iri] : kExamples) {
    EXPECT_EQ(ResolveIri("http://a/b/c/d;p?q", reference), iri) << reference;
  }
}

TEST(Iri, LeavesARelativeReferenceAloneWithoutABase) {
  EXPECT_EQ(ResolveIri("", "g"), "g");
  EXPECT_FALSE(IsAbsoluteIri("1:a"));
  EXPECT_TRUE(IsAbsoluteIri("urn:x"));
}

}  // namespace
}  // namespace kg_base
