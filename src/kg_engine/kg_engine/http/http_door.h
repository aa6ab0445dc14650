// The mission's facts over HTTP (kg_core/protocol), off by default: queries and
// graphs from snapshots on the server's threads; updates one by one on the
// thread that decides on all others.

#ifndef KG_ENGINE_HTTP_HTTP_DOOR_H_
#define KG_ENGINE_HTTP_HTTP_DOOR_H_

#include <string>

#include "kg_engine/http/http_server.h"
#include "kg_engine/protocol/sparql_endpoint.h"

namespace kg_engine {

struct HttpDoorOptions {
  int port = 0;            // On 127.0.0.1; 0: there is no door.
  std::string token_file;  // Empty: no token is asked for.
  bool writable = false;   // Needs a token.
};

class HttpDoor {
 public:
  // Throws kg_core::InputError: no port, no token where one is needed, a token
  // file that everybody can read. port 0 is one that is free here.
  HttpDoor(const HttpDoorOptions& options, kg_engine::EndpointStore store);

  int port() const { return server_.port(); }

 private:
  kg_engine::SparqlEndpoint endpoint_;
  HttpServer server_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_HTTP_HTTP_DOOR_H_
