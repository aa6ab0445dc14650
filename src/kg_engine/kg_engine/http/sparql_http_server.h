// The mission's facts over HTTP (protocol/), off by default: queries and
// graphs from snapshots on the server's threads; updates one by one on the
// thread that decides on all others.

#ifndef KG_ENGINE_HTTP_SPARQL_HTTP_SERVER_H_
#define KG_ENGINE_HTTP_SPARQL_HTTP_SERVER_H_

#include <string>

#include "kg_engine/http/http_server.h"
#include "kg_engine/protocol/sparql_endpoint.h"

namespace kg_engine {

struct SparqlHttpOptions {
  int port = 0;            // On 127.0.0.1; 0: no server.
  std::string token_file;  // Empty: no token is asked for.
  bool writable = false;   // Needs a token.
};

class SparqlHttpServer {
 public:
  // Throws kg_base::InputError: no port, no token where one is needed, a token
  // file that everybody can read. port 0 is one that is free here.
  SparqlHttpServer(const SparqlHttpOptions& options, EndpointStore store);

  int port() const { return server_.port(); }

 private:
  SparqlEndpoint endpoint_;
  HttpServer server_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_HTTP_SPARQL_HTTP_SERVER_H_
