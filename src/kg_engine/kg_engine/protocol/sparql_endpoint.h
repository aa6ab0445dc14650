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

#ifndef KG_ENGINE_PROTOCOL_SPARQL_ENDPOINT_H_
#define KG_ENGINE_PROTOCOL_SPARQL_ENDPOINT_H_

#include "kg_engine/protocol/endpoint_store.h"
#include "kg_engine/protocol/http.h"

namespace kg_engine {

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

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_SPARQL_ENDPOINT_H_
