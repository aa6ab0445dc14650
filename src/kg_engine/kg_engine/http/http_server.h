// An HTTP/1.1 server on the loopback interface, based on cpp-httplib, with
// limits on threads, bytes and time per client. One request per connection.

#ifndef KG_ENGINE_HTTP_HTTP_SERVER_H_
#define KG_ENGINE_HTTP_HTTP_SERVER_H_

#include <cstddef>
#include <functional>
#include <memory>

#include "kg_engine/protocol/http.h"

namespace kg_engine {

struct HttpServerOptions {
  int port = 0;                        // 0 = any free port.
  std::size_t body_bytes = 16u << 20;  // Maximum size of a request body.
  int connections = 16;  // Maximum simultaneous connections in service.
  // Maximum connections that wait for one of these; others wait for accept.
  int waiting = 32;
  int answers = 4;          // Maximum simultaneous handlers; others wait.
  double request_s = 10.0;  // For all of a request to arrive, and again for
                            // its turn, and again for all of the response.
  double crowded_s = 1.0;   // For the head of a request while others wait, so
                            // that idle connections cannot keep them out.
};

class HttpServer {
 public:
  using Handler =
      std::function<kg_engine::HttpResponse(const kg_engine::HttpRequest&)>;

  // Listens on 127.0.0.1 when the constructor returns; calls `handler` from its
  // threads. Throws kg_base::InputError if the port is unavailable.
  HttpServer(const HttpServerOptions& options, Handler handler);
  // Accepts no more requests and waits for running handlers.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

 private:
  class Listener;  // Hides httplib.h from other files.
  std::unique_ptr<Listener> listener_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_HTTP_HTTP_SERVER_H_
