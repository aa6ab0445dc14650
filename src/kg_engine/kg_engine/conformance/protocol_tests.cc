// Tests of the SPARQL 1.1 Protocol and of the service description, asked of an
// endpoint in this process. The manifests have names only; the requests are
// those of https://www.w3.org/2009/sparql/docs/tests/data-sparql11/protocol/

#include <algorithm>
#include <memory>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/update_engine.h"
#include "kg_engine/conformance/test_case.h"
#include "kg_engine/protocol/sparql_endpoint.h"

namespace kg_engine::conformance {
namespace {

using kg_core::Iri;
using kg_core::kFactsGraph;
using kg_core::Statement;
using kg_core::Term;

constexpr char kToken[] = "token of the conformance tests";
constexpr char kForm[] = "application/x-www-form-urlencoded";
constexpr char kQueryType[] = "application/sparql-query";
constexpr char kUpdateType[] = "application/sparql-update";
constexpr char kData[] = "http://kasei.us/2009/09/sparql/data/data";
constexpr char kFoaf[] = "http://xmlns.com/foaf/0.1/";
constexpr char kSd[] = "http://www.w3.org/ns/sparql-service-description#";

// Accepted media types of the answers, by the form of the query.
constexpr char kBooleans[] =
    "application/sparql-results+xml application/sparql-results+json";
constexpr char kRows[] =
    "application/sparql-results+xml application/sparql-results+json "
    "text/tab-separated-values text/csv";
constexpr char kGraphs[] =
    "application/rdf+xml application/rdf+json text/turtle";

constexpr char kPrefixes[] =
    "PREFIX dc: <http://purl.org/dc/terms/>\n"
    "PREFIX foaf: <http://xmlns.com/foaf/0.1/>\n"
    "PREFIX data: <http://kasei.us/2009/09/sparql/data/>\n"
    "PREFIX test: <http://example.org/>\n";
// The default graph, one document in a graph of its own for each number.
constexpr char kThreeDocuments[] =
    "CLEAR ALL ; INSERT DATA {\n"
    "  GRAPH data:data1.rdf { data:data1.rdf a foaf:Document }\n"
    "  GRAPH data:data2.rdf { data:data2.rdf a foaf:Document }\n"
    "  GRAPH data:data3.rdf { data:data3.rdf a foaf:Document } } ;\n";

struct ProtocolCase {
  const char* name;  // Last part of the test's IRI.
  HttpRequest request;
  // Media types that the answer may have, of status 2xx; "": any; null: the
  // answer is to have a status of 4xx.
  const char* media_types;
  const char* answer = "";      // What its body contains.
  std::string true_after = "";  // Query (ASK) that holds afterwards.
};

HttpRequest Get(const std::string& query) {
  return {"GET", "/sparql", query, {}, ""};
}

HttpRequest Post(const std::string& query, const std::string& type,
                 const std::string& body) {
  HttpRequest request{"POST", "/sparql", query, {}, body};
  if (!type.empty()) request.headers["content-type"] = type;
  return request;
}

std::string Parameter(const char* name, const std::string& value) {
  return std::string(name) + "=" + EscapeUrl(value);
}

// A parameter that names the graph of a numbered document.
std::string Document(const char* name, int number) {
  return Parameter(name, kData + std::to_string(number) + ".rdf");
}

std::string InUtf16(const std::string& text) {
  std::string wide = "\xFE\xFF";
  for (const char c : text) wide += {'\0', c};
  return wide;
}

// Queries with a dataset in the request.
std::vector<ProtocolCase> DatasetQueryCases() {
  const std::string both =
      Document("default-graph-uri", 1) + "&" + Document("default-graph-uri", 2);
  const std::string named =
      Document("named-graph-uri", 1) + "&" + Document("named-graph-uri", 2);
  const std::string two_documents =
      std::string(kPrefixes) +
      "ASK { data:data1.rdf ?p ?o . data:data2.rdf ?q "
      "?r }";
  const std::string any_graph = "ASK { GRAPH ?g { ?s ?p ?o } }";
  return {
      {"query_dataset_default_graphs_get",
       Get(Parameter("query", two_documents) + "&" + both), kBooleans, "true"},
      {"query_dataset_default_graphs_post",
       Post(both, kQueryType, two_documents), kBooleans, "true"},
      {"query_dataset_named_graphs_post", Post(named, kQueryType, any_graph),
       kBooleans, "true"},
      {"query_dataset_named_graphs_get",
       Get(named + "&" + Parameter("query", any_graph)), kBooleans, "true"},
      {"query_dataset_full",
       Post(Document("default-graph-uri", 3) + "&" + named, kQueryType,
            "SELECT ?g ?x ?s { ?x ?y ?o GRAPH ?g { ?s ?p ?o } }"),
       kRows, "data2.rdf"},
      {"query_multiple_dataset",
       Post(Document("default-graph-uri", 2), kQueryType,
            std::string(kPrefixes) +
                "ASK FROM data:data1.rdf { data:data1.rdf ?p ?o }"),
       kBooleans, "false"},
  };
}

std::vector<ProtocolCase> QueryCases() {
  const std::string ask = Parameter("query", "ASK {}");
  return {
      {"query_post_form", Post("", kForm, ask), kBooleans, "true"},
      {"query_get", Get(ask), kBooleans, "true"},
      {"query_content_type_select",
       Post("", kQueryType, "SELECT (1 AS ?value) {}"), kRows},
      {"query_content_type_ask", Post("", kQueryType, "ASK {}"), kBooleans},
      {"query_content_type_describe",
       Post("", kQueryType, "DESCRIBE <http://example.org/>"), kGraphs},
      {"query_content_type_construct",
       Post("", kQueryType, "CONSTRUCT { <s> <p> 1 } WHERE {}"), kGraphs},
      {"query_post_direct", Post("", kQueryType, "ASK {}"), kBooleans, "true"},
      {"bad_query_method", {"PUT", "/sparql", ask, {}, ""}, nullptr},
      {"bad_multiple_queries",
       Get(ask + "&" + Parameter("query", "SELECT * {}")), nullptr},
      {"bad_query_wrong_media_type", Post("", "text/plain", "ASK {}"), nullptr},
      {"bad_query_missing_form_type", Post("", "", ask), nullptr},
      {"bad_query_missing_direct_type", Post("", "", "ASK {}"), nullptr},
      {"bad_query_non_utf8",
       Post("", std::string(kQueryType) + "; charset=UTF-16",
            InUtf16("ASK {}")),
       nullptr},
      {"bad_query_syntax", Get(Parameter("query", "ASK {")), nullptr},
  };
}

// Updates with a dataset in the request, and what they are to read of it.
std::vector<ProtocolCase> DatasetUpdateCases() {
  const std::string prefixes = kPrefixes;
  const std::string insert = prefixes + kThreeDocuments +
                             "INSERT { GRAPH test:made { ?s a dc:Resource } } ";
  const std::string plain = insert + "WHERE { ?s a foaf:Document }";
  const std::string named =
      insert + "WHERE { GRAPH ?g { ?s a foaf:Document } }";
  const std::string only_1_and_2 =
      prefixes +
      "ASK { GRAPH test:made { data:data1.rdf a dc:Resource . data:data2.rdf a "
      "dc:Resource } FILTER NOT EXISTS { GRAPH test:made { data:data3.rdf a "
      "dc:Resource } } }";
  const std::string one = Document("using-graph-uri", 1);
  return {
      {"update_dataset_default_graph", Post(one, kUpdateType, plain), "", "",
       prefixes + "ASK { GRAPH test:made { data:data1.rdf a dc:Resource } }"},
      {"update_dataset_default_graphs",
       Post(one + "&" + Document("using-graph-uri", 2), kUpdateType, plain), "",
       "", only_1_and_2},
      {"update_dataset_named_graphs",
       Post(Document("using-named-graph-uri", 1) + "&" +
                Document("using-named-graph-uri", 2),
            kUpdateType, named),
       "", "", only_1_and_2},
      {"update_dataset_full",
       Post(one + "&" + Document("using-named-graph-uri", 2), kUpdateType,
            prefixes + kThreeDocuments +
                "INSERT { GRAPH test:made { ?s test:in ?in } } WHERE { { GRAPH "
                "?g { ?s a foaf:Document } BIND(?g AS ?in) } UNION { ?s a "
                "foaf:Document BIND('default' AS ?in) } }"),
       "", "",
       prefixes +
           "ASK { GRAPH test:made { data:data1.rdf test:in 'default' . "
           "data:data2.rdf test:in data:data2.rdf } FILTER NOT EXISTS { GRAPH "
           "test:made { data:data3.rdf ?p ?o } } }"},
  };
}

std::vector<ProtocolCase> UpdateCases() {
  const std::string with =
      "PREFIX foaf: <http://xmlns.com/foaf/0.1/> WITH "
      "<http://example/addresses> DELETE { ?p foaf:givenName 'Bill' } INSERT { "
      "?p foaf:givenName 'William' } WHERE { ?p foaf:givenName 'Bill' }";
  return {
      {"update_post_form", Post("", kForm, Parameter("update", "CLEAR ALL")),
       ""},
      {"update_post_direct", Post("", kUpdateType, "CLEAR ALL"), ""},
      {"update_base_uri",
       Post("", kUpdateType,
            "CLEAR GRAPH <http://example.org/made> ; INSERT DATA { GRAPH "
            "<http://example.org/made> { <http://example.org/s> "
            "<http://example.org/p> <test> } }"),
       "", "",
       "ASK { GRAPH <http://example.org/made> { ?s ?p ?o FILTER(isIRI(?o) && "
       "STR(?o) != 'test') } }"},
      {"bad_update_get", Get(Parameter("update", "CLEAR ALL")), nullptr},
      {"bad_multiple_updates",
       Post("", kForm,
            Parameter("update", "CLEAR NAMED") + "&" +
                Parameter("update", "CLEAR DEFAULT")),
       nullptr},
      {"bad_update_wrong_media_type", Post("", "text/plain", "CLEAR NAMED"),
       nullptr},
      {"bad_update_missing_form_type",
       Post("", "", Parameter("update", "CLEAR NAMED")), nullptr},
      {"bad_update_non_utf8",
       Post("", std::string(kUpdateType) + "; charset=UTF-16",
            InUtf16("CLEAR NAMED")),
       nullptr},
      {"bad_update_syntax", Post("", kForm, Parameter("update", "CLEAR XYZ")),
       nullptr},
      {"bad_update_dataset_conflict",
       Post("", kForm,
            Parameter("using-named-graph-uri", "http://example/people") + "&" +
                Parameter("update", with)),
       nullptr},
  };
}

// An endpoint of which every graph can be changed, with three documents.
class TestEndpoint {
 public:
  TestEndpoint() {
    kg_core::Transaction change = store_.Begin();
    for (int i = 1; i <= 3; ++i) {
      const Term document = Iri(kData + std::to_string(i) + ".rdf");
      change.Add({document, Iri(std::string(kg_core::kRdf) + "type"),
                  Iri(std::string(kFoaf) + "Document"), document});
    }
    change.Commit(kg_core::WorldChange::kYes);
  }

  HttpResponse Answer(HttpRequest request) const {
    request.headers["host"] = "www.example";
    request.headers["authorization"] = std::string("Bearer ") + kToken;
    return endpoint_.Answer(request);
  }

 private:
  EndpointStore MakeStore() {
    EndpointStore store;
    store.read = [this] { return store_.Read(); };
    store.dataset = [](const kg_core::GraphView&) {
      return kg_core::Dataset{{kFactsGraph}, std::nullopt, kFactsGraph};
    };
    store.update = [this](const kg_core::FactUpdate& update) {
      return Update(update);
    };
    return store;
  }

  UpdateVerdict Update(const kg_core::FactUpdate& update) {
    UpdateVerdict verdict;
    kg_core::UpdateGraphs graphs;
    if (update.sparql_reads) graphs.read = *update.sparql_reads;
    try {
      kg_core::Transaction change = store_.Begin();
      kg_core::RunUpdate(update.sparql, graphs, {}, &change);
      verdict.world_version = change.Commit(kg_core::WorldChange::kYes);
      verdict.outcome = UpdateVerdict::Outcome::kAccepted;
    } catch (const kg_base::InputError& error) {
      verdict.reasons.push_back(error.what());
      verdict.outcome = UpdateVerdict::Outcome::kRefused;
    }
    return verdict;
  }

  kg_core::Store store_{""};
  SparqlEndpoint endpoint_{MakeStore(), {kToken, true}};
};

// Is the type, without its parameters, one of the list?
bool IsListed(const std::string& type, const std::string& list) {
  const std::string name = type.substr(0, type.find(';'));
  return (" " + list + " ").find(" " + name + " ") != std::string::npos;
}

std::string CheckAnswer(const ProtocolCase& test, const HttpResponse& answer) {
  const std::string got = "got " + std::to_string(answer.status) + ": ";
  if (test.media_types == nullptr) {
    return answer.status / 100 == 4 ? "" : got + "expected 4xx";
  }
  if (answer.status / 100 != 2) return got + answer.body;
  const std::string types = test.media_types;
  if (!types.empty() && !IsListed(answer.content_type, types)) {
    return "got " + answer.content_type + ", expected one of " + types;
  }
  return answer.body.find(test.answer) != std::string::npos
             ? ""
             : "expected " + std::string(test.answer) + " in " + answer.body;
}

std::string RunCase(const ProtocolCase& test) {
  const TestEndpoint endpoint;
  std::string difference = CheckAnswer(test, endpoint.Answer(test.request));
  if (!difference.empty() || test.true_after.empty()) return difference;
  const ProtocolCase after{test.name, Post("", kQueryType, test.true_after),
                           kBooleans, "true"};
  difference = CheckAnswer(after, endpoint.Answer(after.request));
  return difference.empty() ? "" : "afterwards " + difference;
}

// The one service of a description.
class DescribedService {
 public:
  explicit DescribedService(const std::string& turtle)
      : statements_(kg_core::ParseTurtle(turtle, "description", Iri(kData))) {
    const Term type = Iri(std::string(kg_core::kRdf) + "type");
    for (const Statement& s : statements_) {
      const bool is_service =
          s.predicate == type && s.object == Iri(std::string(kSd) + "Service");
      if (is_service) services_.push_back(s.subject);
    }
  }
  std::vector<Term> All(const std::vector<Term>& nodes,
                        const char* property) const {
    std::vector<Term> objects;
    for (const Statement& s : statements_) {
      const bool is_of_these =
          std::find(nodes.begin(), nodes.end(), s.subject) != nodes.end();
      if (is_of_these && s.predicate == Iri(std::string(kSd) + property)) {
        objects.push_back(s.object);
      }
    }
    return objects;
  }
  const std::vector<Term>& services() const { return services_; }

 private:
  const std::vector<Statement> statements_;
  std::vector<Term> services_;
};

std::string CheckSchema(const DescribedService& description) {
  if (description.services().size() != 1) return "expected one sd:Service";
  for (const char* property :
       {"endpoint", "supportedLanguage", "resultFormat"}) {
    const auto values = description.All(description.services(), property);
    const bool are_iris =
        std::all_of(values.begin(), values.end(),
                    [](const Term& value) { return value.is_iri(); });
    if (values.empty() || !are_iris) {
      return std::string("expected IRIs of sd:") + property;
    }
  }
  const auto datasets =
      description.All(description.services(), "defaultDataset");
  const auto graphs = description.All(datasets, "namedGraph");
  if (description.All(datasets, "defaultGraph").size() != 1 ||
      description.All(graphs, "name").size() != graphs.size()) {
    return "expected a default dataset with a default graph and named graphs";
  }
  return "";
}

std::string GetName(const TestCase& test) {
  return test.subject.text.substr(test.subject.text.find_last_of("#/") + 1);
}

}  // namespace

std::string RunProtocolTest(const TestCase& test) {
  const std::string name = GetName(test);
  for (const auto& cases : {QueryCases(), DatasetQueryCases(), UpdateCases(),
                            DatasetUpdateCases()}) {
    for (const ProtocolCase& protocol_case : cases) {
      if (name == protocol_case.name) return RunCase(protocol_case);
    }
  }
  throw NotRun("no request is known for this test");
}

std::string RunServiceDescriptionTest(const TestCase& test) {
  const TestEndpoint endpoint;
  const HttpResponse answer = endpoint.Answer(Get(""));
  const ProtocolCase returns_rdf{"", {}, kGraphs};
  const std::string difference = CheckAnswer(returns_rdf, answer);
  const std::string name = GetName(test);
  if (!difference.empty() || name == "returns-rdf") return difference;
  const DescribedService description(answer.body);
  if (name == "conforms-to-schema") return CheckSchema(description);
  if (name != "has-endpoint-triple") {
    throw NotRun("no request is known for this test");
  }
  const auto endpoints = description.All(description.services(), "endpoint");
  const bool is_there =
      endpoints.size() == 1 && endpoints[0] == Iri("http://www.example/sparql");
  return is_there ? "" : "expected sd:endpoint <http://www.example/sparql>";
}

}  // namespace kg_engine::conformance
