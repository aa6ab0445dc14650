// SPARQL 1.1 Protocol and Graph Store HTTP Protocol: a request in, a response
// out. Knows no sockets; kg_ros puts a server before it.
// https://www.w3.org/TR/sparql11-protocol/
// https://www.w3.org/TR/sparql11-http-rdf-update/
//
//   /sparql           queries (GET, POST) and updates (POST); without
//                     parameters, GET answers with the service description
//   /graphs?default   the facts; GET, HEAD, PUT, POST, DELETE
//   /graphs?graph=IRI any graph; only the facts can be written
//   /graphs/NAME      the same as ?graph=http://example.org/mission/graph/NAME
//
// Queries see what queries always see (query_engine.h), end within their limits
// and change nothing. What is to be written goes to the sink, which decides.
// An error is its status and one line of plain text.

#ifndef KG_CORE_PROTOCOL_SPARQL_ENDPOINT_H_
#define KG_CORE_PROTOCOL_SPARQL_ENDPOINT_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kg_core/mission/stage_update.h"
#include "kg_core/protocol/http.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/sparql/query_engine.h"

namespace kg_core {

// What became of an update.
struct UpdateVerdict {
  enum class Outcome {
    kAccepted,  // Durable.
    kRefused,   // For `reasons`; nothing has changed.
    kNobody,    // Nobody decided in time; nothing has changed.
  };
  Outcome outcome = Outcome::kNobody;
  std::vector<std::string> reasons{};
  std::uint64_t world_version = 0;
};

// The store behind an endpoint. All three may be called from several threads at
// once.
struct EndpointStore {
  std::function<std::shared_ptr<const GraphView>()> read;
  std::function<Dataset(const GraphView&)> dataset;
  std::function<UpdateVerdict(const FactUpdate&)> update;
};

struct EndpointOptions {
  std::string token;      // "Authorization: Bearer <token>"; "": none is asked.
  bool writable = false;  // Needs a token.
  QueryLimits limits{};
  std::size_t body_bytes = 16u << 20;  // Of a request.
};

class SparqlEndpoint {
 public:
  // Throws InputError if it were writable by everybody.
  SparqlEndpoint(EndpointStore store, EndpointOptions options);

  // Never throws; from any thread. A response to HEAD has the body of GET:
  // whoever sends it leaves the body out.
  HttpResponse Answer(const HttpRequest& request) const;

 private:
  HttpResponse Dispatch(const HttpRequest& request) const;
  void CheckAccess(const HttpRequest& request) const;

  const EndpointStore store_;
  const EndpointOptions options_;
};

}  // namespace kg_core

#endif  // KG_CORE_PROTOCOL_SPARQL_ENDPOINT_H_
