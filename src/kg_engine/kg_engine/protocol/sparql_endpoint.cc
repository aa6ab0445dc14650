#include "kg_engine/protocol/sparql_endpoint.h"

#include <new>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/common/limit_error.h"
#include "kg_engine/protocol/access.h"
#include "kg_engine/protocol/operations.h"

namespace kg_engine {
namespace {

constexpr char kSparqlPath[] = "/sparql";
constexpr char kGraphsPath[] = "/graphs";

HttpResponse Failure(int status, const std::string& why) {
  HttpResponse response;
  response.status = status;
  response.content_type = kPlainText;
  response.body = why + "\n";
  if (status == kUnauthorized) response.headers["WWW-Authenticate"] = "Bearer";
  if (status == kUnavailable) response.headers["Retry-After"] = "1";
  return response;
}

bool IsGraphPath(const std::string& path) {
  const std::string folder = std::string(kGraphsPath) + "/";
  return path == kGraphsPath || path.compare(0, folder.size(), folder) == 0;
}

}  // namespace

SparqlEndpoint::SparqlEndpoint(EndpointStore store, EndpointOptions options)
    : store_(std::move(store)), options_(std::move(options)) {
  if (options_.writable && options_.token.empty()) {
    throw kg_base::InputError(
        "an endpoint that can be written needs an access token: expected a "
        "token file");
  }
}

HttpResponse SparqlEndpoint::Answer(const HttpRequest& request) const {
  try {
    CheckAccess(request);
    return Dispatch(request);
  } catch (const HttpError& error) {
    return Failure(error.status(), error.what());
  } catch (const kg_base::LimitError& error) {
    return Failure(kUnavailable, error.what());
  } catch (const kg_base::InputError& error) {
    return Failure(kBadRequest, error.what());
  } catch (const std::bad_alloc&) {
    return Failure(kUnavailable, "out of memory");
  } catch (const std::exception& error) {
    return Failure(kInternalError, error.what());
  }
}

void SparqlEndpoint::CheckAccess(const HttpRequest& request) const {
  if (!options_.token.empty()) {
    if (CarriesToken(request, options_.token)) return;
    throw HttpError(kUnauthorized,
                    "expected the header Authorization: Bearer <token>");
  }
  if (!IsLoopbackHost(request)) {
    throw HttpError(kMisdirected,
                    "without a token this endpoint answers to localhost only");
  }
}

HttpResponse SparqlEndpoint::Dispatch(const HttpRequest& request) const {
  if (request.body.size() > options_.body_bytes) {
    throw HttpError(kContentTooLarge, "the body is longer than the limit of " +
                                          std::to_string(options_.body_bytes) +
                                          " bytes");
  }
  const protocol::RequestContext context{request, store_, options_};
  if (request.path == kSparqlPath) return protocol::AnswerSparql(context);
  if (IsGraphPath(request.path)) return protocol::AnswerGraphStore(context);
  throw HttpError(kNotFound,
                  "there is nothing here; expected /sparql, "
                  "/graphs?default or /graphs?graph=<IRI>");
}

namespace protocol {

void CheckWritable(const RequestContext& context) {
  if (context.options.writable) return;
  throw HttpError(kForbidden, "this endpoint is read-only");
}

UpdateVerdict Write(const RequestContext& context, kg_core::FactUpdate update) {
  update.author = GetAuthor(context.request);
  UpdateVerdict verdict = context.store.update(update);
  switch (verdict.outcome) {
    case UpdateVerdict::Outcome::kAccepted:
      return verdict;
    case UpdateVerdict::Outcome::kNobody:
      throw HttpError(kUnavailable,
                      "no decision on the update in time: no change");
    case UpdateVerdict::Outcome::kRefused:
      break;
  }
  throw HttpError(kUnprocessable, kg_base::JoinStrings(verdict.reasons, "\n"));
}

HttpResponse Accepted(int status, const UpdateVerdict& verdict) {
  HttpResponse response;
  response.status = status;
  response.content_type = kPlainText;
  response.body =
      "world version " + std::to_string(verdict.world_version) + "\n";
  return response;
}

HttpResponse NotAllowed(const std::string& allowed) {
  HttpResponse response =
      Failure(kMethodNotAllowed, "expected one of the methods " + allowed);
  response.headers["Allow"] = allowed;
  return response;
}

}  // namespace protocol
}  // namespace kg_engine
