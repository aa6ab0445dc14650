// HTTP requests and responses as plain values, and the functions common to the
// protocols above. Independent of sockets.
// https://www.rfc-editor.org/rfc/rfc9110

#ifndef KG_ENGINE_PROTOCOL_HTTP_H_
#define KG_ENGINE_PROTOCOL_HTTP_H_

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kg_engine {

struct HttpRequest {
  std::string method;  // "GET"
  std::string path;    // Decoded, without the query string.
  std::string query;   // Part after '?', not decoded.
  std::map<std::string, std::string> headers;  // Keyed by name in lower case.
  std::string body;
};

struct HttpResponse {
  int status = 200;
  std::string content_type;  // Empty = no body.
  std::string body;
  std::map<std::string, std::string> headers;  // Further headers, e.g. "Allow".
};

// An error answered by a status and one line with the reason.
class HttpError : public std::runtime_error {
 public:
  HttpError(int status, const std::string& why)
      : std::runtime_error(why), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

// Status codes used here.
inline constexpr int kOk = 200;
inline constexpr int kCreated = 201;
inline constexpr int kPartialContent = 206;
inline constexpr int kBadRequest = 400;
inline constexpr int kUnauthorized = 401;
inline constexpr int kForbidden = 403;
inline constexpr int kNotFound = 404;
inline constexpr int kMethodNotAllowed = 405;
inline constexpr int kNotAcceptable = 406;
inline constexpr int kRequestTimeout = 408;
inline constexpr int kContentTooLarge = 413;
inline constexpr int kUriTooLong = 414;
inline constexpr int kUnsupportedMediaType = 415;
inline constexpr int kRangeNotSatisfiable = 416;
inline constexpr int kMisdirected = 421;
inline constexpr int kUnprocessable = 422;  // Valid request, but rejected.
inline constexpr int kHeadersTooLarge = 431;
inline constexpr int kInternalError = 500;
inline constexpr int kNotImplemented = 501;
inline constexpr int kUnavailable = 503;

inline constexpr char kPlainText[] = "text/plain; charset=utf-8";

// Value of a header; empty if absent. `name` in lower case.
std::string Header(const HttpRequest& request, const std::string& name);

struct FormField {
  std::string name;
  std::string value;
};
// application/x-www-form-urlencoded, of a query string or a body.
// https://url.spec.whatwg.org/#urlencoded-parsing
// Throws HttpError 400 for an escape that is none and for bytes that are not
// UTF-8.
std::vector<FormField> ParseForm(std::string_view text);

// Media type of the body, in lower case and without parameters; "" if not
// given. Throws HttpError 415 for a character set other than UTF-8 and for a
// content coding.
std::string MediaTypeOfBody(const HttpRequest& request);

// Index of the offer (media types, most preferred first) that the Accept header
// selects: the highest quality wins, then the order of the offers. Throws
// HttpError 406 if none matches.
// https://www.rfc-editor.org/rfc/rfc9110#name-accept
std::size_t Negotiate(const std::string& accept,
                      const std::vector<std::string>& offers);

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_HTTP_H_
