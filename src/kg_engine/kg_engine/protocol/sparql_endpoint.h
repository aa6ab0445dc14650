// SPARQL 1.1 Protocol and Graph Store HTTP Protocol: a request in, a response
// out. Independent of sockets; the server is kg_engine/http.
// https://www.w3.org/TR/sparql11-protocol/
// https://www.w3.org/TR/sparql11-http-rdf-update/
//
//   /sparql           queries (GET, POST) and updates (POST); without
//                     parameters, GET answers with the service description
//   /graphs?default   the facts; GET, HEAD, PUT, POST, DELETE
//   /graphs?graph=IRI any graph; only the facts can be written
//   /graphs/NAME      the same as ?graph=http://example.org/mission/graph/NAME
//
// Queries use the default dataset (query_engine.h), are bounded by their limits
// and are read-only. Writes are passed to the sink, which decides. An error is
// a status and one line of plain text.

#ifndef KG_ENGINE_PROTOCOL_SPARQL_ENDPOINT_H_
#define KG_ENGINE_PROTOCOL_SPARQL_ENDPOINT_H_

#include "kg_engine/protocol/endpoint_store.h"
#include "kg_engine/protocol/http.h"

namespace kg_engine {

class SparqlEndpoint {
 public:
  // Throws InputError for a writable endpoint without a token.
  SparqlEndpoint(EndpointStore store, EndpointOptions options);

  // Never throws; may be called from any thread. A response to HEAD has the
  // body of GET; the sender must omit it.
  HttpResponse Answer(const HttpRequest& request) const;

 private:
  HttpResponse Dispatch(const HttpRequest& request) const;
  void CheckAccess(const HttpRequest& request) const;

  const EndpointStore store_;
  const EndpointOptions options_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_SPARQL_ENDPOINT_H_
