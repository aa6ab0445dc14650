// The W3C SHACL Core test suite, as far as it lies in ../shared/data/w3c beside
// the project (or in $KG_SHARED_DATA/w3c): each validation report result by
// result. https://w3c.github.io/data-shapes/data-shapes-test-suite/

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "kg_core/base/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/shacl/rdf_list.h"
#include "kg_core/shacl/validation.h"
#include "kg_core/sparql/vector_view.h"

namespace kg_core {
namespace {

namespace fs = std::filesystem;

constexpr char kMf[] =
    "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#";
constexpr char kSht[] = "http://www.w3.org/ns/shacl-test#";

Term Mf(const char* local) { return Iri(std::string(kMf) + local); }
Term Sht(const char* local) { return Iri(std::string(kSht) + local); }
Term Sh(const char* local) { return Iri(std::string(kSh) + local); }
Term RdfType() { return Iri(std::string(kRdf) + "type"); }

fs::path SuiteFolder() {
  const char* folder = std::getenv("KG_SHARED_DATA");
  return fs::path(folder != nullptr ? folder : "../../../shared/data") / "w3c" /
         "shacl-core";
}

std::string UrlOf(const fs::path& path) { return "file://" + path.string(); }

// Each file is a graph, named by its URL and read once, so that its blank nodes
// are the same as data, as shapes and in the expected report.
void Load(const std::string& url, VectorView* view) {
  Quad any;
  any.graph = view->Find(Iri(url));
  if (any.graph != kNoTerm && view->Estimate(any) > 0) return;
  const fs::path path = url.substr(7);
  std::ifstream in(path, std::ios::binary);
  const std::string text = "@base <" + url + "> .\n" +
                           std::string(std::istreambuf_iterator<char>(in), {});
  for (const Statement& s : ParseTurtle(text, path.string(), Iri(url))) {
    view->Add(s.subject, s.predicate, s.object, s.graph);
  }
}

using Lines = std::multiset<std::string>;

Lines LinesOf(const std::vector<Violation>& violations) {
  Lines lines;
  for (const Violation& v : violations) {
    lines.insert(ToTurtle(v.focus_node) + " | " +
                 (v.path ? shacl::ToTurtle(*v.path) : "") + " | " +
                 (v.has_value() ? ToTurtle(v.value) : "") + " | " +
                 v.component + " | " + ToTurtle(v.severity) + " | " +
                 ToTurtle(v.source_shape));
  }
  return lines;
}

std::string One(const GraphView& view, const std::string& graph,
                const Term& result, const char* property) {
  const auto term = FirstObject(view, graph, result, Sh(property));
  return term ? ToTurtle(*term) : "";
}

// The results of the report at `report`.
Lines LinesOf(const GraphView& view, const std::string& graph,
              const Term& report) {
  Lines lines;
  for (const Term& result : Objects(view, graph, report, Sh("result"))) {
    const auto path = FirstObject(view, graph, result, Sh("resultPath"));
    lines.insert(
        One(view, graph, result, "focusNode") + " | " +
        (path ? shacl::ToTurtle(shacl::ReadPath(view, graph, *path)) : "") +
        " | " + One(view, graph, result, "value") + " | " +
        One(view, graph, result, "sourceConstraintComponent") + " | " +
        One(view, graph, result, "resultSeverity") + " | " +
        One(view, graph, result, "sourceShape"));
  }
  return lines;
}

// Labels of blank nodes are not kept by writing and reading.
Lines WithoutLabels(const Lines& lines) {
  Lines without;
  for (const std::string& line : lines) {
    std::string text;
    for (std::size_t at = 0; at < line.size(); ++at) {
      text += line[at];
      if (line.compare(at, 2, "_:") != 0) continue;
      at = std::min(line.find(' ', at), line.size()) - 1;
    }
    without.insert(text);
  }
  return without;
}

Lines LinesOfReport(const std::string& turtle) {
  const std::string graph = "urn:report";
  VectorView view;
  for (const Statement& s : ParseTurtle(turtle, "report", Iri(graph))) {
    view.Add(s.subject, s.predicate, s.object, s.graph);
  }
  const auto reports = Subjects(view, graph, RdfType(), Sh("ValidationReport"));
  EXPECT_EQ(reports.size(), 1u) << turtle;
  return LinesOf(view, graph, reports.at(0));
}

void Show(const char* what, const Lines& lines) {
  std::cout << "  " << what << "\n";
  for (const std::string& line : lines) std::cout << "    " << line << "\n";
}

bool PassesReport(const std::vector<Violation>& found, const Lines& want,
                  bool conforms) {
  const Lines got = LinesOf(found);
  const Lines read = LinesOfReport(ReportTurtle(found));
  if (got == want && found.empty() == conforms &&
      WithoutLabels(read) == WithoutLabels(want)) {
    return true;
  }
  Show("got", got);
  Show("want", want);
  Show("read", read);
  return false;
}

// One sht:Validate of the graph `manifest`.
bool Passes(VectorView* view, const std::string& manifest, const Term& test) {
  const auto get = [&](const Term& subject, const Term& property) {
    return FirstObject(*view, manifest, subject, property);
  };
  const Term action = get(test, Mf("action")).value();
  const Term result = get(test, Mf("result")).value();
  const std::string data_url = get(action, Sht("dataGraph")).value().text;
  const std::string shapes_url = get(action, Sht("shapesGraph")).value().text;
  Load(data_url, view);
  Load(shapes_url, view);
  try {
    const auto shapes = shacl::LoadShapes(*view, shapes_url);
    const shacl::DataGraph data{*view, data_url, {data_url}, nullptr};
    const auto found = shacl::Validation(data, shapes).Run();
    if (result == Sht("Failure")) return false;
    const bool conforms = get(result, Sh("conforms")).value().text == "true";
    return PassesReport(found, LinesOf(*view, manifest, result), conforms);
  } catch (const InputError& error) {
    std::cout << "  " << error.what() << "\n";
    return result == Sht("Failure");
  }
}

struct Counts {
  int passed = 0;
  int failed = 0;
};

// The tests of a manifest and of those that it includes.
void RunManifest(const std::string& url, Counts* counts) {
  VectorView view;
  Load(url, &view);
  for (const Term& manifest : Subjects(view, url, RdfType(), Mf("Manifest"))) {
    for (const Term& file : Objects(view, url, manifest, Mf("include"))) {
      RunManifest(file.text, counts);
    }
  }
  for (const Term& test : Subjects(view, url, RdfType(), Sht("Validate"))) {
    const bool passed = Passes(&view, url, test);
    ++(passed ? counts->passed : counts->failed);
    EXPECT_TRUE(passed) << test.text;
  }
}

TEST(ShaclW3c, PassesTheSuite) {
  const fs::path suite = fs::absolute(SuiteFolder()).lexically_normal();
  if (!fs::is_directory(suite)) {
    GTEST_SKIP() << "the W3C suite is not there: " << suite;
  }
  int passed = 0;
  for (const auto& folder : fs::directory_iterator(suite)) {
    const fs::path manifest = folder.path() / "manifest.ttl";
    if (!fs::exists(manifest)) continue;
    Counts counts;
    RunManifest(UrlOf(manifest), &counts);
    std::cout << folder.path().filename().string() << ": " << counts.passed
              << " passed, " << counts.failed << " failed\n";
    passed += counts.passed;
  }
  EXPECT_GT(passed, 70);
}

}  // namespace
}  // namespace kg_core
