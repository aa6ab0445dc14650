// Results in XML. https://www.w3.org/TR/rdf-sparql-XMLres/

#include <algorithm>
#include <string>
#include <utility>

#include "kg_base/common/text.h"
#include "kg_base/common/xml_reader.h"
#include "kg_core/sparql/read_results.h"

namespace kg_core {
namespace {

using kg_base::XmlReader;
using kg_base::XmlTag;

Term MakeTerm(const XmlTag& tag, const XmlReader& reader) {
  if (tag.name == "uri") return Iri(tag.text);
  if (tag.name == "bnode") return Blank(tag.text);
  if (tag.name != "literal") reader.Expected("<uri>, <bnode> or <literal>");
  const auto language = tag.attributes.find("xml:lang");
  if (language != tag.attributes.end()) {
    return LanguageLiteral(tag.text, language->second);
  }
  const auto datatype = tag.attributes.find("datatype");
  if (datatype == tag.attributes.end()) return Literal(tag.text);
  return Literal(tag.text, datatype->second);
}

void ReadBinding(const XmlTag& tag, XmlReader* reader, QueryResult* result) {
  const auto name = tag.attributes.find("name");
  const auto& variables = result->variables;
  const auto found =
      name == tag.attributes.end()
          ? variables.end()
          : std::find(variables.begin(), variables.end(), name->second);
  if (found == variables.end() || result->rows.empty()) {
    reader->Expected("the binding of a variable of <head>");
  }
  result->rows.back()[static_cast<std::size_t>(found - variables.begin())] =
      MakeTerm(reader->Next(), *reader);
}

}  // namespace

QueryResult ReadXmlResult(std::string_view text) {
  XmlReader reader(text, "XML result");
  QueryResult result;
  if (reader.Next().name != "sparql") reader.Expected("<sparql>");
  for (XmlTag tag = reader.Next(); !tag.name.empty(); tag = reader.Next()) {
    if (tag.name == "variable") {
      result.variables.push_back(tag.attributes["name"]);
    } else if (tag.name == "boolean") {
      result.form = QueryResult::Form::kAsk;
      result.answer = kg_base::StripAsciiSpace(tag.text) == "true";
    } else if (tag.name == "result") {
      result.rows.emplace_back(result.variables.size());
    } else if (tag.name == "binding") {
      ReadBinding(tag, &reader, &result);
    }
  }
  return result;
}

}  // namespace kg_core
