#include "kg_engine/http/http_door.h"

#include <utility>

#include "kg_engine/protocol/access.h"

namespace kg_engine {
namespace {

kg_engine::EndpointOptions ToEndpoint(const HttpDoorOptions& options) {
  kg_engine::EndpointOptions endpoint;
  if (!options.token_file.empty()) {
    endpoint.token = kg_engine::ReadTokenFile(options.token_file);
  }
  endpoint.writable = options.writable;
  return endpoint;
}

HttpServerOptions ToServer(const HttpDoorOptions& options) {
  HttpServerOptions server;
  server.port = options.port;
  server.body_bytes = kg_engine::EndpointOptions().body_bytes;
  return server;
}

}  // namespace

HttpDoor::HttpDoor(const HttpDoorOptions& options,
                   kg_engine::EndpointStore store)
    : endpoint_(std::move(store), ToEndpoint(options)),
      server_(ToServer(options), [this](const kg_engine::HttpRequest& request) {
        return endpoint_.Answer(request);
      }) {}

}  // namespace kg_engine
