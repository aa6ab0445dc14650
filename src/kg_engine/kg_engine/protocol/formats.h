// Formats of answers, chosen by the Accept header.

#ifndef KG_ENGINE_PROTOCOL_FORMATS_H_
#define KG_ENGINE_PROTOCOL_FORMATS_H_

#include <string>
#include <vector>

#include "kg_core/sparql/query_result.h"
#include "kg_engine/protocol/http.h"

namespace kg_engine {

// A media type and its writer.
struct AnswerFormat {
  std::string media_type;
  std::string (*write)(const kg_core::QueryResult& result);
};

// Rows and answers of ASK: results JSON, XML, CSV, TSV, a table of plain text.
// Triples: Turtle, N-Triples, RDF/XML.
enum class AnswerKind { kRows, kTriples };
const std::vector<AnswerFormat>& AnswerFormats(AnswerKind kind);

// Throws HttpError 406.
const AnswerFormat& ChooseFormat(const HttpRequest& request, AnswerKind kind);

HttpResponse WriteAnswer(const kg_core::QueryResult& result,
                         const AnswerFormat& format);

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_FORMATS_H_
