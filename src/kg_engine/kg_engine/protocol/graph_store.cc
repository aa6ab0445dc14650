// https://www.w3.org/TR/sparql11-http-rdf-update/
#include <string>
#include <vector>

#include "kg_base/common/limit_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_engine/protocol/formats.h"
#include "kg_engine/protocol/operations.h"

namespace kg_engine::protocol {
namespace {

using kg_core::GraphView;
using kg_core::Iri;
using kg_core::kFactsGraph;
using kg_core::kNoTerm;
using kg_core::Triple;

constexpr char kFolder[] = "/graphs/";

struct GraphName {
  std::string iri;
  bool is_default = false;  // Asked for as the default graph, not by its name.
};

// https://www.w3.org/TR/sparql11-http-rdf-update/#graph-identification
GraphName GetGraph(const HttpRequest& request) {
  const std::string folder = kFolder;
  if (request.path.size() > folder.size()) {
    return {kg_core::kGraph + request.path.substr(folder.size()), false};
  }
  const std::vector<FormField> fields = ParseForm(request.query);
  if (fields.size() == 1) {
    if (fields[0].name == "default" && fields[0].value.empty()) {
      return {kFactsGraph, true};
    }
    if (fields[0].name == "graph" && !fields[0].value.empty()) {
      return {fields[0].value, false};
    }
  }
  throw HttpError(kBadRequest,
                  "expected one parameter: ?default or "
                  "?graph=<IRI>");
}

std::vector<Triple> CollectTriples(const GraphView& view,
                                   const std::string& graph,
                                   const kg_core::QueryLimits& limits) {
  std::vector<Triple> triples;
  const kg_core::TermId id = view.Find(Iri(graph));
  if (id == kNoTerm) return triples;
  std::size_t bytes = 0;
  view.Match({kNoTerm, kNoTerm, kNoTerm, id}, [&](const kg_core::Quad& quad) {
    triples.push_back({view.Get(quad.subject), view.Get(quad.predicate),
                       view.Get(quad.object)});
    const Triple& triple = triples.back();
    bytes += triple.subject.text.size() + triple.predicate.text.size() +
             triple.object.text.size();
    if (triples.size() > limits.rows || bytes > limits.bytes) {
      throw kg_base::LimitError("the graph is larger than the limit of " +
                                std::to_string(limits.rows) + " triples or " +
                                std::to_string(limits.bytes) + " bytes");
    }
    return true;
  });
  return triples;
}

// The default graph exists even if it has no triples.
bool Exists(const GraphView& view, const GraphName& graph) {
  if (graph.is_default) return true;
  const kg_core::TermId id = view.Find(Iri(graph.iri));
  bool found = false;
  if (id == kNoTerm) return found;
  view.Match({kNoTerm, kNoTerm, kNoTerm, id}, [&](const kg_core::Quad&) {
    found = true;
    return false;
  });
  return found;
}

void CheckExists(const GraphView& view, const GraphName& graph) {
  if (Exists(view, graph)) return;
  throw HttpError(kNotFound, "the store has no graph <" + graph.iri + ">");
}

// https://www.w3.org/TR/sparql11-http-rdf-update/#http-get
HttpResponse Get(const RequestContext& context, const GraphName& graph) {
  const AnswerFormat& format =
      ChooseFormat(context.request, AnswerKind::kTriples);
  const auto view = context.store.read();
  CheckExists(*view, graph);
  kg_core::QueryResult result;
  result.form = kg_core::QueryResult::Form::kConstruct;
  result.triples = CollectTriples(*view, graph.iri, context.options.limits);
  return WriteAnswer(result, format);
}

// The payload as Turtle, which includes N-Triples.
const std::string& Payload(const HttpRequest& request) {
  const std::string type = MediaTypeOfBody(request);
  if (type == "text/turtle" || type == "application/n-triples" ||
      type == "application/x-turtle") {
    return request.body;
  }
  throw HttpError(kUnsupportedMediaType,
                  "expected Content-Type text/turtle or application/n-triples" +
                      (type.empty() ? "" : ", not " + type));
}

// https://www.w3.org/TR/sparql11-http-rdf-update/#http-put, #http-post,
// #http-delete
HttpResponse Change(const RequestContext& context, const GraphName& graph) {
  CheckWritable(context);
  if (graph.iri != kFactsGraph) {
    throw HttpError(kForbidden, "graph <" + graph.iri +
                                    "> cannot be written here; only <" +
                                    kFactsGraph + "> can");
  }
  const HttpRequest& request = context.request;
  const auto view = context.store.read();
  kg_core::FactUpdate update;
  update.replaces_facts = request.method != "POST";
  if (request.method == "DELETE") {
    CheckExists(*view, graph);
  } else {
    update.turtle = Payload(request);
    kg_core::ParseTurtle(update.turtle, "body",
                         Iri(graph.iri));  // 400 if malformed.
  }
  const int status = Exists(*view, graph) ? kOk : kCreated;
  return Accepted(status, Write(context, std::move(update)));
}

}  // namespace

HttpResponse AnswerGraphStore(const RequestContext& context) {
  const std::string& method = context.request.method;
  const GraphName graph = GetGraph(context.request);
  if (method == "GET" || method == "HEAD") return Get(context, graph);
  if (method == "PUT" || method == "POST" || method == "DELETE") {
    return Change(context, graph);
  }
  return NotAllowed("GET, HEAD, PUT, POST, DELETE");
}

}  // namespace kg_engine::protocol
