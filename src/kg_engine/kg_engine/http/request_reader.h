// Reads one HTTP/1.1 request within limits of bytes, before a server's library
// parses it, and rewrites what cpp-httplib reads wrongly or without a limit:
// lines of any length, chunked bodies, targets in absolute form, ranges.
// https://www.rfc-editor.org/rfc/rfc9112

#ifndef KG_ENGINE_HTTP_REQUEST_READER_H_
#define KG_ENGINE_HTTP_REQUEST_READER_H_

#include <cstddef>
#include <functional>
#include <string>

namespace kg_engine {

struct RequestLimits {
  // Request line and header fields together; also trailer fields.
  std::size_t head_bytes = 32u << 10;
  std::size_t body_bytes = 16u << 20;  // Of a body.
};

struct RequestText {
  // The head in origin form, without Range; then the body if it was sent in
  // chunks, under a Content-Length. Any other body is still to be read. Empty:
  // the client closed, or sent nothing in time.
  std::string text;
  std::string range;  // The one Range field; empty if none or several.
};

// Reads up to `size` bytes. Returns their number, 0 if the client has sent all,
// below 0 if none came in time.
using ReadBytes = std::function<std::ptrdiff_t(char* bytes, std::size_t size)>;

// Called between the head and a body in chunks. `is_awaited`: the client waits
// for "100 Continue".
using BeforeBody = std::function<void(bool is_awaited)>;

// Throws HttpError: 400 malformed, 408 not whole in time, 413 and 414 and 431
// longer than the limits, 501 a transfer coding other than chunked.
RequestText ReadRequest(const RequestLimits& limits, const ReadBytes& read,
                        const BeforeBody& before_body);

}  // namespace kg_engine

#endif  // KG_ENGINE_HTTP_REQUEST_READER_H_
