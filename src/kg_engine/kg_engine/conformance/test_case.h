// One test as its manifest describes it, and the ways to run it.

#ifndef KG_ENGINE_CONFORMANCE_TEST_CASE_H_
#define KG_ENGINE_CONFORMANCE_TEST_CASE_H_

#include <string>

#include "kg_engine/conformance/documents.h"

namespace kg_engine::conformance {

struct TestCase {
  DocumentStore* documents;  // Holds the manifest.
  std::string manifest;      // URL of the manifest.
  kg_core::Term subject;     // The test's node.
  std::string kind;          // Local name of its type.

  // Values of a property in the manifest, by its full IRI.
  std::optional<kg_core::Term> One(const kg_core::Term& node,
                                   const std::string& property) const {
    return documents->One(manifest, node, property);
  }
  std::vector<kg_core::Term> All(const kg_core::Term& node,
                                 const std::string& property) const {
    return documents->All(manifest, node, property);
  }
  // Throw InputError if the manifest lacks the property.
  kg_core::Term Action() const;
  kg_core::Term Result() const;
};

// Each returns the difference between actual and expected result; "" if none.
// All throw NotRun, and InputError for unreadable files.
std::string RunQueryTest(const TestCase& test);
std::string RunUpdateTest(const TestCase& test);
std::string RunPositiveSyntaxTest(const TestCase& test);
std::string RunNegativeSyntaxTest(const TestCase& test);
std::string RunShaclTest(const TestCase& test);
std::string RunProtocolTest(const TestCase& test);
std::string RunServiceDescriptionTest(const TestCase& test);
std::string RunRdfEvaluationTest(const TestCase& test);
std::string RunRdfPositiveSyntaxTest(const TestCase& test);
std::string RunRdfNegativeSyntaxTest(const TestCase& test);

}  // namespace kg_engine::conformance

#endif  // KG_ENGINE_CONFORMANCE_TEST_CASE_H_
