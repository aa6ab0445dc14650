// Who may ask.

#ifndef KG_ENGINE_PROTOCOL_ACCESS_H_
#define KG_ENGINE_PROTOCOL_ACCESS_H_

#include <string>

#include "kg_engine/protocol/http.h"

namespace kg_engine {

// Does the request carry "Authorization: Bearer <token>" (RFC 6750)? Takes the
// same time for every wrong token.
bool CarriesToken(const HttpRequest& request, const std::string& token);

// Is the Host a name of this machine's loopback? A page in a browser can make
// its own name resolve to 127.0.0.1 and read what comes back; it cannot change
// the Host it is asked by.
bool IsLoopbackHost(const HttpRequest& request);

// A token out of a file: its one line. Throws InputError if the file cannot be
// read, can be read by others than its owner and group, or holds no token of
// 16 to 512 visible ASCII characters.
std::string ReadTokenFile(const std::string& path);

// Who the request says it is from (header From), else "http".
std::string GetAuthor(const HttpRequest& request);

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_ACCESS_H_
