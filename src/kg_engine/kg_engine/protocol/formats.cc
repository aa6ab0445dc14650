#include "kg_engine/protocol/formats.h"

#include "kg_core/rdf/term.h"
#include "kg_core/sparql/results.h"
#include "kg_engine/protocol/write_rdf_xml.h"

namespace kg_engine {
namespace {

using kg_core::QueryResult;
using kg_core::ToNTriples;

std::string WriteTurtleAnswer(const QueryResult& result) {
  return kg_core::TriplesToTurtle(result.triples);
}

std::string WriteRdfXmlAnswer(const QueryResult& result) {
  return TriplesToRdfXml(result.triples);
}

std::string WriteNTriplesAnswer(const QueryResult& result) {
  std::string out;
  for (const kg_core::Triple& triple : result.triples) {
    out += ToNTriples(triple.subject) + " " + ToNTriples(triple.predicate) +
           " " + ToNTriples(triple.object) + " .\n";
  }
  return out;
}

// The last ones are aliases that clients use.
std::vector<AnswerFormat> RowFormats() {
  std::vector<AnswerFormat> formats;
  for (const kg_core::ResultFormat& format : kg_core::ResultFormats()) {
    formats.push_back({format.media_type, format.write});
  }
  formats.push_back({"application/json", kg_core::ToJson});
  formats.push_back({"application/xml", kg_core::ToXml});
  formats.push_back({"text/xml", kg_core::ToXml});
  return formats;
}

bool IsText(const std::string& media_type) {
  return media_type.compare(0, 5, "text/") == 0;
}

}  // namespace

const std::vector<AnswerFormat>& AnswerFormats(AnswerKind kind) {
  static const auto* const rows = new std::vector<AnswerFormat>(RowFormats());
  static const auto* const triples = new std::vector<AnswerFormat>{
      {"text/turtle", WriteTurtleAnswer},
      {"application/n-triples", WriteNTriplesAnswer},
      {"application/rdf+xml", WriteRdfXmlAnswer},
      {"application/x-turtle", WriteTurtleAnswer},
      {"text/plain", WriteNTriplesAnswer},
  };
  return kind == AnswerKind::kRows ? *rows : *triples;
}

const AnswerFormat& ChooseFormat(const HttpRequest& request, AnswerKind kind) {
  std::vector<std::string> offers;
  for (const AnswerFormat& format : AnswerFormats(kind)) {
    offers.push_back(format.media_type);
  }
  return AnswerFormats(kind)[Negotiate(Header(request, "accept"), offers)];
}

HttpResponse WriteAnswer(const QueryResult& result,
                         const AnswerFormat& format) {
  HttpResponse response;
  response.content_type =
      format.media_type + (IsText(format.media_type) ? "; charset=utf-8" : "");
  response.body = format.write(result);
  return response;
}

}  // namespace kg_engine
