// https://www.w3.org/TR/sparql11-protocol/#protocol
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/sparql/parser.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/resolve_dataset.h"
#include "kg_engine/protocol/formats.h"
#include "kg_engine/protocol/operations.h"

namespace kg_engine::protocol {
namespace {

using kg_core::Dataset;

constexpr char kForm[] = "application/x-www-form-urlencoded";
constexpr char kQueryType[] = "application/sparql-query";
constexpr char kUpdateType[] = "application/sparql-update";
constexpr char kDefaultGraphUri[] = "default-graph-uri";
constexpr char kNamedGraphUri[] = "named-graph-uri";
constexpr char kUsingGraphUri[] = "using-graph-uri";
constexpr char kUsingNamedGraphUri[] = "using-named-graph-uri";

std::vector<std::string> Values(const std::vector<FormField>& fields,
                                const std::string& name) {
  std::vector<std::string> values;
  for (const FormField& field : fields) {
    if (field.name == name) values.push_back(field.value);
  }
  return values;
}

// Value of a parameter that may occur once. Unknown names (format=, timeout=,
// used by other servers) are ignored.
std::string TheOnly(const std::vector<FormField>& fields,
                    const std::string& name) {
  const std::vector<std::string> values = Values(fields, name);
  if (values.size() == 1) return values[0];
  throw HttpError(kBadRequest, "expected one parameter '" + name + "', not " +
                                   std::to_string(values.size()));
}

bool HasField(const std::vector<FormField>& fields, const std::string& name) {
  return !Values(fields, name).empty();
}

void CheckLength(const std::string& text, const RequestContext& context) {
  const std::size_t limit = context.options.limits.text_bytes;
  if (text.size() <= limit) return;
  throw HttpError(kContentTooLarge, "the text is longer than the limit of " +
                                        std::to_string(limit) + " bytes");
}

// Dataset chosen by the parameters of these names; its graphs must exist.
std::optional<Dataset> ChosenDataset(const std::vector<FormField>& fields,
                                     const char* defaults, const char* named,
                                     const kg_core::GraphView& view) {
  if (!HasField(fields, defaults) && !HasField(fields, named)) {
    return std::nullopt;
  }
  Dataset dataset;
  dataset.default_graphs = Values(fields, defaults);
  dataset.named_graphs = Values(fields, named);
  dataset.is_binding = true;
  for (const char* name : {defaults, named}) {
    for (const std::string& graph : Values(fields, name)) {
      if (kg_core::sparql::HasGraph(view, graph)) continue;
      throw HttpError(
          kBadRequest,
          std::string(name) + ": the store has no graph <" + graph + ">");
    }
  }
  return dataset;
}

AnswerKind GetKind(const kg_core::sparql::Query& query) {
  const bool rows = query.form == kg_core::sparql::Query::Form::kSelect ||
                    query.form == kg_core::sparql::Query::Form::kAsk;
  return rows ? AnswerKind::kRows : AnswerKind::kTriples;
}

// https://www.w3.org/TR/sparql11-protocol/#query-operation
HttpResponse AnswerQuery(const RequestContext& context, const std::string& text,
                         const std::vector<FormField>& fields) {
  CheckLength(text, context);
  const kg_core::QueryLimits& limits = context.options.limits;
  const kg_core::sparql::Query query =
      kg_core::sparql::ParseQuery(text, limits.nesting);
  const AnswerFormat& format = ChooseFormat(context.request, GetKind(query));
  const auto view = context.store.read();
  std::optional<Dataset> dataset =
      ChosenDataset(fields, kDefaultGraphUri, kNamedGraphUri, *view);
  if (!dataset) dataset = context.store.dataset(*view);
  return WriteAnswer(kg_core::RunQuery(*view, text, *dataset, limits), format);
}

// https://www.w3.org/TR/sparql11-protocol/#update-operation: parameters and the
// text itself must not both choose.
void RefuseTwoDatasets(const kg_core::sparql::UpdateRequest& update) {
  for (const kg_core::sparql::UpdateOperation& operation : update.operations) {
    if (!operation.query.has_dataset && !operation.with) continue;
    throw HttpError(kBadRequest,
                    "expected using-graph-uri and using-named-graph-uri, or "
                    "USING and WITH in the update, not both");
  }
}

// https://www.w3.org/TR/sparql11-protocol/#update-operation
HttpResponse AnswerUpdate(const RequestContext& context,
                          const std::string& text,
                          const std::vector<FormField>& fields) {
  CheckWritable(context);
  CheckLength(text, context);
  const kg_core::sparql::UpdateRequest parsed =
      kg_core::sparql::ParseUpdate(text, context.options.limits.nesting);
  kg_core::FactUpdate update;
  update.sparql = text;
  update.sparql_reads = ChosenDataset(
      fields, kUsingGraphUri, kUsingNamedGraphUri, *context.store.read());
  if (update.sparql_reads) RefuseTwoDatasets(parsed);
  return Accepted(kOk, Write(context, std::move(update)));
}

HttpResponse AnswerForm(const RequestContext& context,
                        const std::vector<FormField>& fields) {
  const bool queries = HasField(fields, "query");
  if (queries == HasField(fields, "update")) {
    throw HttpError(kBadRequest, "expected one parameter, 'query' or 'update'");
  }
  if (queries) return AnswerQuery(context, TheOnly(fields, "query"), fields);
  return AnswerUpdate(context, TheOnly(fields, "update"), fields);
}

HttpResponse AnswerPost(const RequestContext& context) {
  const HttpRequest& request = context.request;
  const std::string type = MediaTypeOfBody(request);
  if (type == kForm) {
    std::vector<FormField> fields = ParseForm(request.body);
    for (FormField& field : ParseForm(request.query)) {
      fields.push_back(std::move(field));
    }
    return AnswerForm(context, fields);
  }
  if (type != kQueryType && type != kUpdateType) {
    throw HttpError(kUnsupportedMediaType,
                    "expected Content-Type " + std::string(kForm) + ", " +
                        kQueryType + " or " + kUpdateType +
                        (type.empty() ? "" : ", not " + type));
  }
  if (kg_base::FirstBadUtf8(request.body)) {
    throw HttpError(kBadRequest, "expected a body in UTF-8");
  }
  const std::vector<FormField> fields = ParseForm(request.query);
  if (HasField(fields, "query") || HasField(fields, "update")) {
    throw HttpError(kBadRequest, "expected the text in the body only");
  }
  if (type == kQueryType) return AnswerQuery(context, request.body, fields);
  return AnswerUpdate(context, request.body, fields);
}

HttpResponse AnswerGet(const RequestContext& context) {
  const std::vector<FormField> fields = ParseForm(context.request.query);
  if (fields.empty()) return DescribeService(context);
  if (HasField(fields, "update")) {
    throw HttpError(kBadRequest, "an update cannot be sent with GET");
  }
  return AnswerQuery(context, TheOnly(fields, "query"), fields);
}

}  // namespace

HttpResponse AnswerSparql(const RequestContext& context) {
  const std::string& method = context.request.method;
  if (method == "GET" || method == "HEAD") return AnswerGet(context);
  if (method == "POST") return AnswerPost(context);
  return NotAllowed("GET, HEAD, POST");
}

}  // namespace kg_engine::protocol
