// An HTTP/1.1 server on the loopback interface, by cpp-httplib, with bounds on
// everything a client may do: threads, bytes, time. One request a connection.

#ifndef KG_ENGINE_HTTP_HTTP_SERVER_H_
#define KG_ENGINE_HTTP_HTTP_SERVER_H_

#include <cstddef>
#include <functional>
#include <memory>

#include "kg_engine/protocol/http.h"

namespace kg_engine {

struct HttpServerOptions {
  int port = 0;                        // 0: any that is free.
  std::size_t body_bytes = 16u << 20;  // Longest body that is read.
  int connections = 16;                // At once; others wait for accept.
  int answers = 4;                     // At once; others wait their turn.
  double request_s = 10.0;  // For all of a request to arrive, and again for
                            // its turn, and again for all of the response.
};

class HttpServer {
 public:
  using Handler =
      std::function<kg_engine::HttpResponse(const kg_engine::HttpRequest&)>;

  // Listens on 127.0.0.1 when this returns; calls `handler` from its threads.
  // Throws kg_base::InputError if the port cannot be had.
  HttpServer(const HttpServerOptions& options, Handler handler);
  // Takes no more requests, waits for those whose handler has been called.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

 private:
  class Listener;  // Keeps httplib.h out of other files.
  std::unique_ptr<Listener> listener_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_HTTP_HTTP_SERVER_H_
