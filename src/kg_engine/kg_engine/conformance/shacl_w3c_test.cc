// The W3C SHACL Core test suite: each validation report result by result.
// https://w3c.github.io/data-shapes/data-shapes-test-suite/

#include "gtest/gtest.h"
#include "kg_engine/conformance/testing/w3c_suite.h"

namespace kg_engine {
namespace {

TEST(ShaclW3c, PassesTheSuite) { ExpectSuitePasses("shacl-core", 70); }

}  // namespace
}  // namespace kg_engine
