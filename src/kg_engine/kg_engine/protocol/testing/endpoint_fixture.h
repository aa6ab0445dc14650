// For tests: a small mission behind an endpoint, and requests to it. Tests run
// in the package's source folder.

#ifndef KG_ENGINE_PROTOCOL_TESTING_ENDPOINT_FIXTURE_H_
#define KG_ENGINE_PROTOCOL_TESTING_ENDPOINT_FIXTURE_H_

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/read_results.h"
#include "kg_engine/protocol/sparql_endpoint.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_engine {

inline constexpr char kToken[] = "correct horse battery staple";
inline constexpr char kAgents[] = "SELECT ?a { ?a a ex:Agent } ORDER BY ?a";
inline constexpr char kForm[] = "application/x-www-form-urlencoded";
inline constexpr char kQuery[] = "application/sparql-query";
inline constexpr char kUpdate[] = "application/sparql-update";

inline std::string Encode(const std::string& text) {
  std::string out;
  for (const char c : text) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
    out += code;
  }
  return out;
}

inline std::string Field(const std::string& name, const std::string& value) {
  return name + "=" + Encode(value);
}

inline HttpRequest Get(const std::string& path, const std::string& query = "") {
  return {"GET", path, query, {}, ""};
}

inline HttpRequest Send(const std::string& method, const std::string& path,
                        const std::string& type, const std::string& body) {
  HttpRequest request{method, path, "", {}, body};
  if (!type.empty()) request.headers["content-type"] = type;
  return request;
}

inline HttpRequest Ask(const std::string& query, const std::string& more = "") {
  return Get("/sparql", Field("query", query) + more);
}

inline HttpRequest Change(const std::string& update) {
  return Send("POST", "/sparql", kUpdate, update);
}

inline HttpRequest With(HttpRequest request, const std::string& name,
                        const std::string& value) {
  request.headers[name] = value;
  return request;
}

struct BadRequest {
  const char* what;
  HttpRequest request;
  int status;
};

// A small mission behind a writable endpoint.
class SparqlEndpointTest : public testing::Test {
 protected:
  EndpointStore StoreOfTheWorld() {
    EndpointStore store;
    store.read = [this] { return world_.store.Read(); };
    store.dataset = [](const kg_core::GraphView&) {
      return kg_core::DefaultDataset(std::nullopt);
    };
    store.update = [this](const kg_core::FactUpdate& update) {
      UpdateVerdict verdict;
      authors_.push_back(update.author);
      verdict.reasons = world_.Commit(update);
      verdict.outcome = verdict.reasons.empty()
                            ? UpdateVerdict::Outcome::kAccepted
                            : UpdateVerdict::Outcome::kRefused;
      verdict.world_version = world_.store.world_version();
      return verdict;
    };
    return store;
  }

  HttpResponse Answer(HttpRequest request) {
    request.headers.emplace("authorization", std::string("Bearer ") + kToken);
    return endpoint_.Answer(request);
  }
  // Value of the single row and column of the answer to `query`.
  std::string Value(const std::string& query) {
    const HttpResponse response = Answer(Ask(query));
    EXPECT_EQ(response.status, 200) << response.body;
    const kg_core::QueryResult result = kg_core::ReadJsonResult(response.body);
    return result.rows.size() == 1 ? result.rows[0][0]->text : "no answer";
  }
  std::string Facts() {
    return kg_core::WriteTurtle(*world_.store.Read(), kg_core::kFactsGraph);
  }

  kg_mission::MissionWorld world_;
  std::vector<std::string> authors_;
  SparqlEndpoint endpoint_{StoreOfTheWorld(), {kToken, true, {}, 1u << 20}};
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_TESTING_ENDPOINT_FIXTURE_H_
