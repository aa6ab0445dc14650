// Access control of the endpoint.

#ifndef KG_ENGINE_PROTOCOL_ACCESS_H_
#define KG_ENGINE_PROTOCOL_ACCESS_H_

#include <string>

#include "kg_engine/protocol/http.h"

namespace kg_engine {

// Whether the request carries "Authorization: Bearer <token>" (RFC 6750). Takes
// constant time for wrong tokens.
bool CarriesToken(const HttpRequest& request, const std::string& token);

// Whether the Host header is a loopback name of this machine. Guards against
// DNS rebinding: a web page can make its own name resolve to 127.0.0.1 and read
// the response, but cannot change the Host header.
bool IsLoopbackHost(const HttpRequest& request);

// Reads the token, the only line of the file. Throws InputError if the file
// cannot be read, is accessible to others than its owner and group, or contains
// no token of 16 to 512 visible ASCII characters.
std::string ReadTokenFile(const std::string& path);

// Author of the request (header From), else "http".
std::string GetAuthor(const HttpRequest& request);

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_ACCESS_H_
