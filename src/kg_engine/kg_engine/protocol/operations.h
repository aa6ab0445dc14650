// The two protocols' operations, after access has been checked and before
// errors become responses: they throw HttpError, InputError and LimitError.
// For sparql_endpoint.cc only.

#ifndef KG_ENGINE_PROTOCOL_OPERATIONS_H_
#define KG_ENGINE_PROTOCOL_OPERATIONS_H_

#include "kg_engine/protocol/endpoint_store.h"
#include "kg_engine/protocol/http.h"

namespace kg_engine::protocol {

struct RequestContext {
  const HttpRequest& request;
  const EndpointStore& store;
  const EndpointOptions& options;
};

// /sparql; throws HttpError for what is neither a query nor an update.
// https://www.w3.org/TR/sparql11-protocol/#protocol
HttpResponse AnswerSparql(const RequestContext& context);

// /graphs. https://www.w3.org/TR/sparql11-http-rdf-update/
HttpResponse AnswerGraphStore(const RequestContext& context);

// https://www.w3.org/TR/sparql11-service-description/
HttpResponse DescribeService(const RequestContext& context);

// Throws HttpError 403 if the endpoint is read-only.
void CheckWritable(const RequestContext& context);

// Passes an update to the sink: throws HttpError 422 with the reasons if it was
// rejected; else returns the verdict.
UpdateVerdict Write(const RequestContext& context, kg_core::FactUpdate update);

// The response to a client for a verdict.
HttpResponse Accepted(int status, const UpdateVerdict& verdict);

// Response 405 naming the allowed methods ("GET, HEAD").
HttpResponse NotAllowed(const std::string& allowed);

}  // namespace kg_engine::protocol

#endif  // KG_ENGINE_PROTOCOL_OPERATIONS_H_
