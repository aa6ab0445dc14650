#include "kg_core/rdf/namespaces.h"

#include "gtest/gtest.h"

namespace kg_core {
namespace {

TEST(Namespaces, EveryPrefixExpandsAndAbbreviates) {
  for (const NamespacePrefix& prefix : kPrefixes) {
    const std::string name = std::string(prefix.name) + ":x-1_y";
    EXPECT_EQ(ExpandPrefixed(name), std::string(prefix.iri) + "x-1_y");
    EXPECT_EQ(AbbreviateIri(*ExpandPrefixed(name)), name);
  }
}

TEST(Namespaces, UnknownPrefixHasNoAnswer) {
  EXPECT_FALSE(ExpandPrefixed("foaf:name"));
  EXPECT_FALSE(ExpandPrefixed("alpha"));
  EXPECT_FALSE(ExpandPrefixed(""));
}

TEST(Namespaces, AbbreviatesOnlyPlainLocalNames) {
  for (const char* local : {"", "a/b", "a.b", "-a", "a b", "a:b", "\xC3\xA9"}) {
    const std::string iri = kEx + std::string(local);
    EXPECT_EQ(AbbreviateIri(iri), "<" + iri + ">");
  }
}

}  // namespace
}  // namespace kg_core
