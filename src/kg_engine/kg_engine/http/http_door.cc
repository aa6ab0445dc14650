#include "kg_engine/http/http_door.h"

#include <utility>

#include "kg_core/protocol/access.h"

namespace kg_engine {
namespace {

kg_core::EndpointOptions ToEndpoint(const HttpDoorOptions& options) {
  kg_core::EndpointOptions endpoint;
  if (!options.token_file.empty()) {
    endpoint.token = kg_core::ReadTokenFile(options.token_file);
  }
  endpoint.writable = options.writable;
  return endpoint;
}

HttpServerOptions ToServer(const HttpDoorOptions& options) {
  HttpServerOptions server;
  server.port = options.port;
  server.body_bytes = kg_core::EndpointOptions().body_bytes;
  return server;
}

}  // namespace

HttpDoor::HttpDoor(const HttpDoorOptions& options, kg_core::EndpointStore store)
    : endpoint_(std::move(store), ToEndpoint(options)),
      server_(ToServer(options), [this](const kg_core::HttpRequest& request) {
        return endpoint_.Answer(request);
      }) {}

}  // namespace kg_engine
