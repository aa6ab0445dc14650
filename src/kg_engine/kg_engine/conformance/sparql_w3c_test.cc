// The W3C SPARQL 1.1 test suite: evaluation and syntax of queries and updates,
// and result formats. https://www.w3.org/2009/sparql/docs/tests/

#include "gtest/gtest.h"
#include "kg_engine/conformance/testing/w3c_suite.h"

namespace kg_engine {
namespace {

TEST(SparqlW3c, PassesTheSuite) { ExpectSuitePasses("sparql11", 200); }

}  // namespace
}  // namespace kg_engine
