// The W3C SPARQL 1.1 test suite, as far as it lies in ../shared/data/w3c beside
// the project (or in $KG_SHARED_DATA/w3c): evaluation and syntax of queries and
// updates, and result formats. Every group that lies there is run.
// https://www.w3.org/2009/sparql/docs/tests/

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/base/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/isomorphism.h"
#include "kg_core/sparql/parser.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/read_results.h"
#include "kg_core/sparql/results.h"
#include "kg_core/sparql/update_engine.h"
#include "kg_core/sparql/values.h"
#include "kg_core/sparql/vector_view.h"

namespace kg_core {
namespace {

namespace fs = std::filesystem;

using Statements = std::vector<Statement>;

constexpr char kMf[] =
    "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#";
constexpr char kQt[] = "http://www.w3.org/2001/sw/DataAccess/tests/test-query#";
constexpr char kUt[] = "http://www.w3.org/2009/sparql/tests/test-update#";
constexpr char kRs[] = "http://www.w3.org/2001/sw/DataAccess/tests/result-set#";
constexpr char kDefault[] = "urn:default";  // What has no name in the tests.

fs::path SuiteFolder() {
  const char* folder = std::getenv("KG_SHARED_DATA");
  return fs::path(folder != nullptr ? folder : "../../../shared/data") / "w3c" /
         "sparql11";
}

std::string TextOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string UrlOf(const fs::path& path) { return "file://" + path.string(); }
fs::path PathOf(const std::string& url) { return url.substr(7); }

std::string RequestOf(const std::string& url) {
  return "BASE <" + url + ">\n" + TextOf(PathOf(url));
}

Statements ReadStatements(const std::string& url, const std::string& graph) {
  return ParseTurtle("@base <" + url + "> .\n" + TextOf(PathOf(url)), url,
                     Iri(graph));
}

// Turtle that can be asked.
class Facts {
 public:
  explicit Facts(const std::string& url) {
    for (const Statement& s : ReadStatements(url, kDefault)) {
      view_.Add(s.subject, s.predicate, s.object, s.graph);
    }
  }
  std::vector<Term> All(const Term& subject,
                        const std::string& property) const {
    return Objects(view_, kDefault, subject, Iri(property));
  }
  std::optional<Term> One(const Term& subject,
                          const std::string& property) const {
    return FirstObject(view_, kDefault, subject, Iri(property));
  }
  std::vector<Term> OfType(const std::string& type) const {
    return Subjects(view_, kDefault, Iri(std::string(kRdf) + "type"),
                    Iri(type));
  }

 private:
  VectorView view_;
};

// A file and the graph that it is read into.
struct Source {
  std::string url;
  std::string graph;
};

struct Case {
  std::string name;
  std::string type;
  std::string request;  // URLs.
  std::string result;
  std::vector<Source> before;
  std::vector<Source> after;  // Of updates.
};

std::vector<Source> SourcesOf(const Facts& facts, const Term& state,
                              const std::string& vocabulary) {
  std::vector<Source> sources;
  for (const Term& data : facts.All(state, vocabulary + "data")) {
    sources.push_back({data.text, kDefault});
  }
  for (const Term& data : facts.All(state, vocabulary + "graphData")) {
    const auto file = facts.One(data, vocabulary + "graph");
    const auto label = facts.One(data, std::string(kRdfs) + "label");
    sources.push_back(file && label ? Source{file->text, label->text}
                                    : Source{data.text, data.text});
  }
  return sources;
}

Case ReadCase(const Facts& facts, const Term& subject,
              const std::string& type) {
  Case test;
  test.type = type;
  test.name = subject.text.substr(subject.text.find_last_of("#/") + 1);
  const Term action = *facts.One(subject, std::string(kMf) + "action");
  const auto result = facts.One(subject, std::string(kMf) + "result");
  const auto query = facts.One(action, std::string(kQt) + "query");
  const auto request = facts.One(action, std::string(kUt) + "request");
  test.request = request ? request->text : query ? query->text : action.text;
  if (result) test.result = result->text;
  test.before = SourcesOf(facts, action, request ? kUt : kQt);
  if (result) test.after = SourcesOf(facts, *result, kUt);
  return test;
}

// Numbers by value; labels of results are not those of rows.
Term Canonical(const Term& term) {
  if (term.is_blank()) return Blank("result" + term.text);
  const auto number = sparql::ToNumber(term);
  return number ? sparql::ToTerm(*number) : term;
}

// Rows as statements about one blank node each, so that they are a bag and
// share the blank nodes in them.
Statements RowsOf(const QueryResult& result) {
  Statements statements;
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const Term row = Blank("row" + std::to_string(i));
    statements.push_back({row, Iri("urn:is"), Iri("urn:row"), Iri("urn:g")});
    for (std::size_t j = 0; j < result.variables.size(); ++j) {
      if (!result.rows[i][j]) continue;
      statements.push_back({row, Iri("urn:var:" + result.variables[j]),
                            Canonical(*result.rows[i][j]), Iri("urn:g")});
    }
  }
  return statements;
}

// CSV writes blank nodes as text.
QueryResult WithBlanks(QueryResult result) {
  for (auto& row : result.rows) {
    for (std::optional<Term>& term : row) {
      if (term && term->text.rfind("_:", 0) == 0) {
        term = Blank(term->text.substr(2));
      }
    }
  }
  return result;
}

// A table in Turtle.
QueryResult ReadResultSet(const Facts& facts) {
  const Term set = facts.OfType(std::string(kRs) + "ResultSet").at(0);
  const std::string rs = kRs;
  QueryResult result;
  for (const Term& name : facts.All(set, rs + "resultVariable")) {
    result.variables.push_back(name.text);
  }
  for (const Term& solution : facts.All(set, rs + "solution")) {
    result.rows.emplace_back(result.variables.size());
    for (const Term& binding : facts.All(solution, rs + "binding")) {
      const std::string name = facts.One(binding, rs + "variable")->text;
      for (std::size_t i = 0; i < result.variables.size(); ++i) {
        if (result.variables[i] != name) continue;
        result.rows.back()[i] = facts.One(binding, rs + "value");
      }
    }
  }
  return result;
}

struct Format {
  const char* suffix;
  std::string (*write)(const QueryResult&);
  QueryResult (*read)(std::string_view);
};
constexpr Format kFormats[] = {{".srx", ToXml, ReadXmlResult},
                               {".srj", ToJson, ReadJsonResult},
                               {".tsv", ToTsv, ReadTsvResult},
                               {".csv", ToCsv, ReadCsvResult}};

Statements StatementsOf(const std::vector<Triple>& triples) {
  Statements statements;
  for (const Triple& t : triples) {
    statements.push_back({t.subject, t.predicate, t.object, Iri(kDefault)});
  }
  return statements;
}

QueryResult RunTest(const Case& test) {
  VectorView view;
  Dataset dataset{{kDefault}, std::vector<std::string>(), ""};
  for (const Source& source : test.before) {
    for (const Statement& s : ReadStatements(source.url, source.graph)) {
      view.Add(s.subject, s.predicate, s.object, s.graph);
    }
    if (source.graph != kDefault) {
      dataset.named_graphs->push_back(source.graph);
    }
  }
  return RunQuery(view, RequestOf(test.request), dataset, {});
}

bool CheckTurtle(const Case& test, const QueryResult& got) {
  if (got.form == QueryResult::Form::kSelect) {
    return IsIsomorphic(RowsOf(got), RowsOf(ReadResultSet(Facts(test.result))));
  }
  return IsIsomorphic(StatementsOf(got.triples),
                      ReadStatements(test.result, kDefault));
}

// What is compared went through the writer and the reader of its format.
bool CheckEvaluation(const Case& test) {
  const QueryResult result = RunTest(test);
  const std::string suffix = fs::path(test.result).extension();
  if (suffix == ".ttl") return CheckTurtle(test, result);
  for (const Format& format : kFormats) {
    if (suffix != format.suffix) continue;
    QueryResult got = format.read(format.write(result));
    QueryResult want = format.read(TextOf(PathOf(test.result)));
    if (suffix == ".csv") got = WithBlanks(std::move(got));
    if (suffix == ".csv") want = WithBlanks(std::move(want));
    return got.form == want.form && got.answer == want.answer &&
           IsIsomorphic(RowsOf(got), RowsOf(want));
  }
  throw InputError("no reader for " + test.result);
}

Statements ContentOf(const std::vector<Source>& sources) {
  Statements all;
  for (const Source& source : sources) {
    for (Statement& s : ReadStatements(source.url, source.graph)) {
      all.push_back(std::move(s));
    }
  }
  return all;
}

Statements ContentOf(const GraphView& view) {
  Statements all;
  view.Match({}, [&](const Quad& q) {
    all.push_back({view.Get(q.subject), view.Get(q.predicate),
                   view.Get(q.object), view.Get(q.graph)});
    return true;
  });
  return all;
}

bool CheckUpdate(const Case& test) {
  Store store("");
  Transaction change = store.Begin();
  for (const Statement& s : ContentOf(test.before)) change.Add(s);
  UpdateGraphs graphs;
  graphs.default_graph = kDefault;
  graphs.read = {{kDefault}, std::nullopt, kDefault};
  RunUpdate(RequestOf(test.request), graphs, {}, &change);
  change.Commit(WorldChange::kYes);
  return IsIsomorphic(ContentOf(*store.Read()), ContentOf(test.after));
}

// Requests that end in .ru are updates, whatever their type says.
void Parse(const Case& test) {
  const bool update = fs::path(test.request).extension() == ".ru";
  if (update) sparql::ParseUpdate(RequestOf(test.request), 200);
  if (!update) sparql::ParseQuery(RequestOf(test.request), 200);
}

bool IsRead(const Case& test) {
  Parse(test);
  return true;
}

bool IsRefused(const Case& test) {
  try {
    Parse(test);
  } catch (const InputError&) {
    return true;
  }
  return false;
}

struct TestType {
  const char* name;
  bool (*check)(const Case& test);
};
constexpr TestType kTypes[] = {
    {"QueryEvaluationTest", CheckEvaluation},
    {"CSVResultFormatTest", CheckEvaluation},
    {"UpdateEvaluationTest", CheckUpdate},
    {"PositiveSyntaxTest11", IsRead},
    {"PositiveUpdateSyntaxTest11", IsRead},
    {"NegativeSyntaxTest11", IsRefused},
    {"NegativeUpdateSyntaxTest11", IsRefused},
};

bool Passes(const Case& test, bool (*check)(const Case& test)) {
  try {
    if (check(test)) return true;
    std::cout << test.request << " differs\n";
  } catch (const InputError& error) {
    std::cout << test.request << " " << error.what() << "\n";
  }
  return false;
}

TEST(SparqlW3c, PassesTheSuite) {
  const fs::path suite = fs::absolute(SuiteFolder()).lexically_normal();
  if (!fs::is_directory(suite)) {
    GTEST_SKIP() << "the W3C suite is not there: " << suite;
  }
  int passed = 0;
  for (const auto& folder : fs::directory_iterator(suite)) {
    const Facts manifest(UrlOf(folder.path() / "manifest.ttl"));
    std::map<bool, int> counts;
    for (const TestType& type : kTypes) {
      for (const Term& subject :
           manifest.OfType(kMf + std::string(type.name))) {
        const Case test = ReadCase(manifest, subject, type.name);
        const bool good = Passes(test, type.check);
        EXPECT_TRUE(good) << test.type << " " << test.name;
        ++counts[good];
      }
    }
    std::cout << folder.path().filename().string() << ": " << counts[true]
              << " passed, " << counts[false] << " failed\n";
    passed += counts[true];
  }
  EXPECT_GT(passed, 200);
}

}  // namespace
}  // namespace kg_core
