// The W3C test suites of Turtle, TriG, N-Triples and N-Quads.
// https://www.w3.org/2013/TurtleTests/ and others, see test_data/w3c/README.md

#include "gtest/gtest.h"
#include "kg_engine/conformance/testing/w3c_suite.h"

namespace kg_engine {
namespace {

// Not run are the tests with NUL.
TEST(RdfW3c, PassesTheSuites) {
  ExpectOutcomes("turtle", 286, 0, 5);
  ExpectOutcomes("trig", 330, 0, 5);
  ExpectOutcomes("ntriples", 67, 0, 1);
  ExpectOutcomes("nquads", 84, 0, 1);
}

}  // namespace
}  // namespace kg_engine
