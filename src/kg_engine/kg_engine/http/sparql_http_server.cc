#include "kg_engine/http/sparql_http_server.h"

#include <utility>

#include "kg_engine/protocol/access.h"

namespace kg_engine {
namespace {

EndpointOptions ToEndpoint(const SparqlHttpOptions& options) {
  EndpointOptions endpoint;
  if (!options.token_file.empty()) {
    endpoint.token = ReadTokenFile(options.token_file);
  }
  endpoint.writable = options.writable;
  return endpoint;
}

HttpServerOptions ToServer(const SparqlHttpOptions& options) {
  HttpServerOptions server;
  server.port = options.port;
  server.body_bytes = EndpointOptions().body_bytes;
  return server;
}

}  // namespace

SparqlHttpServer::SparqlHttpServer(const SparqlHttpOptions& options,
                                   EndpointStore store)
    : endpoint_(std::move(store), ToEndpoint(options)),
      server_(ToServer(options), [this](const HttpRequest& request) {
        return endpoint_.Answer(request);
      }) {}

}  // namespace kg_engine
