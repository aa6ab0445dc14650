// Tests of queries and updates. https://www.w3.org/2009/sparql/docs/tests/

#include <filesystem>
#include <set>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/parser.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/update_engine.h"
#include "kg_engine/conformance/result_set.h"
#include "kg_engine/conformance/test_case.h"

namespace kg_engine::conformance {
namespace {

using kg_core::Statement;
using kg_core::Store;
using kg_core::Term;

using Statements = std::vector<Statement>;

constexpr int kNesting = 200;
constexpr char kServiceDescription[] =
    "http://www.w3.org/ns/sparql-service-description#";

// Generous limits: these tests do not test time, and some machines are slow.
kg_core::QueryLimits Limits() {
  kg_core::QueryLimits limits;
  limits.seconds = 60.0;
  return limits;
}

// A file and the graph into which it is read.
struct GraphSource {
  std::string url;
  std::string graph;
};

std::vector<GraphSource> CollectSources(const TestCase& test, const Term& state,
                                        const std::string& vocabulary) {
  std::vector<GraphSource> sources;
  for (const Term& data : test.All(state, vocabulary + "data")) {
    sources.push_back({data.text, kDefaultGraph});
  }
  for (const Term& data : test.All(state, vocabulary + "graphData")) {
    const auto file = test.One(data, vocabulary + "graph");
    const auto label = test.One(data, std::string(kg_core::kRdfs) + "label");
    sources.push_back(file && label ? GraphSource{file->text, label->text}
                                    : GraphSource{data.text, data.text});
  }
  return sources;
}

// The URL of the query or update.
std::string RequestUrl(const TestCase& test) {
  const Term action = test.Action();
  for (const char* property : {"query", "request"}) {
    for (const char* vocabulary : {kQt, kUt}) {
      const auto url = test.One(action, std::string(vocabulary) + property);
      if (url) return url->text;
    }
  }
  if (action.is_iri()) return action.text;
  throw kg_base::InputError("the action names no query");
}

// Request text with its URL as BASE, on the first line so that positions in
// errors keep their line numbers.
std::string MakeRequest(const std::string& url) {
  std::string text = GetText(url);
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);
  return "BASE <" + url + "> " + text;
}

void RefuseWhatCannotBeRun(const TestCase& test) {
  const Term action = test.Action();
  const auto regime =
      test.One(action, std::string(kServiceDescription) + "entailmentRegime");
  if (regime || test.One(test.subject, std::string(kMf) + "entailmentRegime")) {
    throw NotRun("needs an entailment regime");
  }
  if (test.One(action, std::string(kQt) + "serviceData")) {
    throw NotRun("needs a SPARQL endpoint to federate with");
  }
}

Statements GetContent(const std::vector<GraphSource>& sources) {
  Statements all;
  for (const GraphSource& source : sources) {
    for (Statement& s : CollectStatements(source.url, source.graph)) {
      all.push_back(std::move(s));
    }
  }
  return all;
}

Statements GetContent(const kg_core::GraphView& view) {
  Statements all;
  view.Match({}, [&](const kg_core::Quad& q) {
    all.push_back({view.Get(q.subject), view.Get(q.predicate),
                   view.Get(q.object), view.Get(q.graph)});
    return true;
  });
  return all;
}

void Fill(const std::vector<GraphSource>& sources, Store* store) {
  kg_core::Transaction change = store->Begin();
  for (const Statement& s : GetContent(sources)) change.Add(s);
  change.Commit(kg_core::WorldChange::kYes);
}

// Adds graphs named by FROM and FROM NAMED but not by the manifest: replaces
// dereferencing from the web.
void AddGraphsOfQuery(const std::string& request,
                      std::vector<GraphSource>* sources) {
  const kg_core::sparql::Query query =
      kg_core::sparql::ParseQuery(request, kNesting);
  std::set<std::string> known;
  for (const GraphSource& source : *sources) known.insert(source.graph);
  for (const auto* names : {&query.from, &query.from_named}) {
    for (const std::string& name : *names) {
      if (known.insert(name).second) sources->push_back({name, name});
    }
  }
}

// Files that end in .ru are updates, regardless of their type.
bool IsUpdate(const TestCase& test, const std::string& url) {
  return std::filesystem::path(url).extension() == ".ru" ||
         test.kind.find("Update") != std::string::npos;
}

void Parse(const TestCase& test, const std::string& url) {
  const std::string request = MakeRequest(url);
  if (IsUpdate(test, url)) {
    kg_core::sparql::ParseUpdate(request, kNesting);
  } else {
    kg_core::sparql::ParseQuery(request, kNesting);
  }
}

}  // namespace

std::string RunQueryTest(const TestCase& test) {
  RefuseWhatCannotBeRun(test);
  const std::string request = MakeRequest(RequestUrl(test));
  std::vector<GraphSource> sources = CollectSources(test, test.Action(), kQt);
  AddGraphsOfQuery(request, &sources);
  Store store("");
  Fill(sources, &store);
  kg_core::Dataset dataset{{kDefaultGraph}, std::vector<std::string>(), ""};
  for (const GraphSource& source : sources) {
    if (source.graph == kDefaultGraph) continue;
    dataset.named_graphs->push_back(source.graph);
  }
  const kg_core::QueryResult got =
      kg_core::RunQuery(*store.Read(), request, dataset, Limits());
  const std::string expected = test.Result().text;
  const auto cardinality =
      test.One(test.subject, std::string(kMf) + "resultCardinality");
  const bool is_lax =
      cardinality && cardinality->text == std::string(kMf) + "LaxCardinality";
  return Difference(ThroughFormat(got, expected), ReadExpected(expected),
                    is_lax);
}

std::string RunUpdateTest(const TestCase& test) {
  RefuseWhatCannotBeRun(test);
  Store store("");
  Fill(CollectSources(test, test.Action(), kUt), &store);
  kg_core::UpdateGraphs graphs;
  graphs.default_graph = kDefaultGraph;
  graphs.read = {{kDefaultGraph}, std::nullopt, kDefaultGraph};
  kg_core::Transaction change = store.Begin();
  kg_core::RunUpdate(MakeRequest(RequestUrl(test)), graphs, Limits(), &change);
  return Difference(GetContent(change.view()),
                    GetContent(CollectSources(test, test.Result(), kUt)));
}

std::string RunPositiveSyntaxTest(const TestCase& test) {
  Parse(test, RequestUrl(test));
  return "";
}

std::string RunNegativeSyntaxTest(const TestCase& test) {
  const std::string url = RequestUrl(test);
  GetText(url);  // A missing file is not a syntax error.
  try {
    Parse(test, url);
  } catch (const kg_base::InputError&) {
    return "";
  }
  return "was read, but is no SPARQL";
}

}  // namespace kg_engine::conformance
