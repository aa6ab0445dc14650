#include "kg_engine/conformance/conformance.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "kg_base/common/input_error.h"
#include "kg_base/common/one_line.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/rdf_list.h"
#include "kg_engine/conformance/test_case.h"

namespace kg_engine {
namespace {

using kg_core::Term;

using kg_base::InputError;

}  // namespace
namespace conformance {
namespace {

namespace fs = std::filesystem;
using Outcome = ConformanceTest::Outcome;

constexpr char kApproval[] =
    "http://www.w3.org/2001/sw/DataAccess/tests/test-dawg#approval";

struct TestKind {
  const char* vocabulary;
  const char* name;
  std::string (*run)(const TestCase& test);  // Null = cannot be run.
};
constexpr TestKind kKinds[] = {
    {kMf, "QueryEvaluationTest", RunQueryTest},
    {kMf, "CSVResultFormatTest", RunQueryTest},
    {kMf, "UpdateEvaluationTest", RunUpdateTest},
    {kUt, "UpdateEvaluationTest", RunUpdateTest},
    {kMf, "PositiveSyntaxTest", RunPositiveSyntaxTest},
    {kMf, "PositiveSyntaxTest11", RunPositiveSyntaxTest},
    {kMf, "PositiveUpdateSyntaxTest", RunPositiveSyntaxTest},
    {kMf, "PositiveUpdateSyntaxTest11", RunPositiveSyntaxTest},
    {kMf, "NegativeSyntaxTest", RunNegativeSyntaxTest},
    {kMf, "NegativeSyntaxTest11", RunNegativeSyntaxTest},
    {kMf, "NegativeUpdateSyntaxTest", RunNegativeSyntaxTest},
    {kMf, "NegativeUpdateSyntaxTest11", RunNegativeSyntaxTest},
    {kSht, "Validate", RunShaclTest},
    {kRdft, "TestTurtleEval", RunRdfEvaluationTest},
    {kRdft, "TestTurtlePositiveSyntax", RunRdfPositiveSyntaxTest},
    {kRdft, "TestTurtleNegativeSyntax", RunRdfNegativeSyntaxTest},
    {kRdft, "TestTurtleNegativeEval", RunRdfNegativeSyntaxTest},
    {kRdft, "TestTrigEval", RunRdfEvaluationTest},
    {kRdft, "TestTrigPositiveSyntax", RunRdfPositiveSyntaxTest},
    {kRdft, "TestTrigNegativeSyntax", RunRdfNegativeSyntaxTest},
    {kRdft, "TestTrigNegativeEval", RunRdfNegativeSyntaxTest},
    {kRdft, "TestNTriplesPositiveSyntax", RunRdfPositiveSyntaxTest},
    {kRdft, "TestNTriplesNegativeSyntax", RunRdfNegativeSyntaxTest},
    {kRdft, "TestNQuadsPositiveSyntax", RunRdfPositiveSyntaxTest},
    {kRdft, "TestNQuadsNegativeSyntax", RunRdfNegativeSyntaxTest},
    {kMf, "ProtocolTest", RunProtocolTest},
    {kMf, "GraphStoreProtocolTest", nullptr},
    {kMf, "ServiceDescriptionTest", RunServiceDescriptionTest},
};

const TestKind* FindKind(const Term& type) {
  for (const TestKind& kind : kKinds) {
    if (type.text == kind.vocabulary + std::string(kind.name)) return &kind;
  }
  return nullptr;
}

std::string GetEnd(const std::string& iri) {
  return iri.substr(iri.find_last_of("#/") + 1);
}

class ManifestRunner {
 public:
  ManifestRunner(fs::path root,
                 absl::FunctionRef<void(const ConformanceTest&)> done,
                 const KnownDeviations& deviations)
      : root_(std::move(root)), done_(done), deviations_(deviations) {}

  // Runs the tests of a manifest and of the manifests it includes; each file
  // once.
  void RunManifest(const std::string& url) {
    if (!manifests_.insert(url).second) return;
    DocumentStore documents;
    try {
      documents.Load(url);
      RunEntries(&documents, url);
    } catch (const InputError& error) {
      Report({GetGroup(url), GetEnd(url), url, "Manifest", Outcome::kFailed,
              error.what()});
    } catch (const NotRun& reason) {
      Report({GetGroup(url), GetEnd(url), url, "Manifest", Outcome::kNotRun,
              reason.what()});
    }
  }

  std::vector<ConformanceTest> Take() { return std::move(tests_); }

 private:
  std::string GetGroup(const std::string& url) const {
    const std::string prefix = UrlOfPath(root_.string());
    if (url.compare(0, prefix.size(), prefix) != 0) return url;
    const fs::path folder = fs::path(PathOfUrl(url)).parent_path();
    const std::string group = fs::relative(folder, root_).string();
    return group == "." ? root_.filename().string() : group;
  }

  void RunEntries(DocumentStore* documents, const std::string& url) {
    const std::string mf = kMf;
    for (const Term& manifest : documents->OfType(url, mf + "Manifest")) {
      for (const Term& node : Listed(*documents, url, manifest, "include")) {
        RunManifest(node.text);
      }
      for (const Term& test : Listed(*documents, url, manifest, "entries")) {
        RunTest({documents, url, test, ""});
      }
    }
  }

  // Values of a property; lists are expanded to their members.
  static std::vector<Term> Listed(const DocumentStore& documents,
                                  const std::string& url, const Term& manifest,
                                  const char* property) {
    std::vector<Term> nodes;
    for (const Term& value :
         documents.All(url, manifest, std::string(kMf) + property)) {
      const auto list = kg_core::ReadList(documents.view(), url, value);
      if (!list && value.is_blank()) {
        throw InputError(PathOfUrl(url) + ": mf:" + property + " is no list");
      }
      if (list) nodes.insert(nodes.end(), list->begin(), list->end());
      if (!list) nodes.push_back(value);
    }
    return nodes;
  }

  void RunTest(TestCase test) {
    ConformanceTest report;
    report.group = GetGroup(test.manifest);
    report.iri = test.subject.is_iri() ? test.subject.text : "";
    const auto name = test.One(test.subject, std::string(kMf) + "name");
    report.name = test.subject.is_iri() ? GetEnd(test.subject.text)
                  : name                ? name->text
                                        : "";
    const TestKind* kind = GetKind(test, &test.kind);
    report.kind = test.kind;
    try {
      report.message = Run(test, kind);
      if (report.message.empty()) report.outcome = Outcome::kPassed;
    } catch (const NotRun& reason) {
      report.outcome = Outcome::kNotRun;
      report.message = reason.what();
    } catch (const InputError& error) {
      report.message = error.what();
    }
    Report(std::move(report));
  }

  // The first known type. In old manifests no type means query evaluation.
  static const TestKind* GetKind(const TestCase& test, std::string* name) {
    const auto types =
        test.All(test.subject, std::string(kg_core::kRdf) + "type");
    for (const Term& type : types) {
      if (const TestKind* kind = FindKind(type)) {
        *name = kind->name;
        return kind;
      }
    }
    *name = types.empty() ? kKinds[0].name : GetEnd(types[0].text);
    return types.empty() ? &kKinds[0] : nullptr;
  }

  static std::string Run(const TestCase& test, const TestKind* kind) {
    const auto approval = test.One(test.subject, kApproval);
    if (approval && GetEnd(approval->text) == "Withdrawn") {
      throw NotRun("withdrawn by the working group");
    }
    if (kind == nullptr)
      throw NotRun("no test of SPARQL, SHACL or an RDF syntax");
    if (kind->run == nullptr) throw NotRun("needs a SPARQL server");
    return kind->run(test);
  }

  void Report(ConformanceTest test) {
    ApplyDeviation(&test);
    test.message = kg_base::OneLine(test.message);
    done_(test);
    tests_.push_back(std::move(test));
  }

  void ApplyDeviation(ConformanceTest* test) const {
    const auto known = deviations_.find(test->iri);
    if (known == deviations_.end()) return;
    if (test->outcome == Outcome::kFailed) {
      test->outcome = Outcome::kDeviates;
      test->message = known->second;
    } else if (test->outcome == Outcome::kPassed) {
      test->outcome = Outcome::kFailed;
      test->message = "passes, but is listed as deviating";
    }
  }

  const fs::path root_;
  absl::FunctionRef<void(const ConformanceTest&)> done_;
  const KnownDeviations& deviations_;
  std::set<std::string> manifests_;
  std::vector<ConformanceTest> tests_;
};

bool IsManifest(const fs::path& path) {
  return path.extension() == ".ttl" &&
         path.filename().string().rfind("manifest", 0) == 0;
}

std::vector<fs::path> ManifestsIn(const fs::path& folder) {
  if (fs::is_regular_file(folder)) return {folder};
  std::vector<fs::path> manifests;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(
           folder, fs::directory_options::follow_directory_symlink, error)) {
    if (IsManifest(entry.path())) manifests.push_back(entry.path());
  }
  std::sort(manifests.begin(), manifests.end());
  return manifests;
}

}  // namespace

Term TestCase::Action() const {
  const auto action = One(subject, std::string(kMf) + "action");
  if (!action) throw InputError("the test has no mf:action");
  return *action;
}

Term TestCase::Result() const {
  const auto result = One(subject, std::string(kMf) + "result");
  if (!result) throw InputError("the test has no mf:result");
  return *result;
}

}  // namespace conformance

KnownDeviations ReadDeviations(const std::string& path) {
  constexpr std::size_t kMaxBytes = 1u << 20;
  KnownDeviations deviations;
  std::istringstream lines(kg_base::ReadFile(path, kMaxBytes));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t space = line.find(' ');
    const bool is_new =
        space != std::string::npos && space + 1 < line.size() &&
        deviations.emplace(line.substr(0, space), line.substr(space + 1))
            .second;
    if (is_new) continue;
    throw InputError(path + ":" + std::to_string(number) +
                     ": expected the IRI of another test, a space and a "
                     "reason");
  }
  return deviations;
}

std::vector<ConformanceTest> RunConformance(
    const std::string& folder,
    absl::FunctionRef<void(const ConformanceTest&)> done,
    const KnownDeviations& deviations) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) throw InputError(folder + ": " + error.message());
  const auto manifests = conformance::ManifestsIn(root);
  if (manifests.empty()) {
    throw InputError(folder + ": expected a manifest*.ttl somewhere below it");
  }
  const bool is_file = fs::is_regular_file(root);
  conformance::ManifestRunner runner(is_file ? root.parent_path() : root, done,
                                     deviations);
  for (const fs::path& manifest : manifests) {
    runner.RunManifest(conformance::UrlOfPath(manifest.string()));
  }
  return runner.Take();
}

ConformanceCount CountOutcomes(const std::vector<ConformanceTest>& tests) {
  ConformanceCount count;
  for (const ConformanceTest& test : tests) {
    switch (test.outcome) {
      case ConformanceTest::Outcome::kPassed:
        ++count.passed;
        break;
      case ConformanceTest::Outcome::kFailed:
        ++count.failed;
        break;
      case ConformanceTest::Outcome::kDeviates:
        ++count.deviating;
        break;
      case ConformanceTest::Outcome::kNotRun:
        ++count.not_run;
        break;
    }
  }
  return count;
}

}  // namespace kg_engine
