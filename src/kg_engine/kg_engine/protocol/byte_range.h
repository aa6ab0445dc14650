// Range requests on answers that are held as a whole.
// https://www.rfc-editor.org/rfc/rfc9110#name-range-requests

#ifndef KG_ENGINE_PROTOCOL_BYTE_RANGE_H_
#define KG_ENGINE_PROTOCOL_BYTE_RANGE_H_

#include "kg_engine/protocol/http.h"

namespace kg_engine {

// Reduces the response to the part that the request's Range header asks for:
// 206 with Content-Range, or 416 if the part lies behind the end. Applies to a
// GET that would be answered by 200, and to one range in bytes. All else leaves
// the response as it is, as RFC 9110, 14.2 allows: other methods and statuses,
// other units, malformed ranges, several ranges (a short request could ask for
// many copies), and If-Range, since responses have no validators.
void ApplyRange(const HttpRequest& request, HttpResponse* response);

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_BYTE_RANGE_H_
