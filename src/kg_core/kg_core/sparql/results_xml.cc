// Results as XML. https://www.w3.org/TR/rdf-sparql-XMLres/

#include <cstddef>
#include <string_view>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/results.h"

namespace kg_core {
namespace {

constexpr char kReplacement[] = "\xEF\xBF\xBD";  // U+FFFD

// Is the text at byte `at` U+FFFE or U+FFFF, which XML may not hold even
// escaped?
bool IsNoncharacter(std::string_view text, std::size_t at) {
  const std::string_view code = text.substr(at, 3);
  return code == "\xEF\xBF\xBE" || code == "\xEF\xBF\xBF";
}

// https://www.w3.org/TR/xml/#syntax, #charsets; a literal carriage return would
// be read back as a line feed (#sec-line-ends).
std::string XmlText(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      // XML readers turn a bare carriage return into a line feed.
      case '\r':
        out += "&#13;";
        break;
      case '\n':
      case '\t':
        out.push_back(c);
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          out += kReplacement;
        } else if (IsNoncharacter(text, i)) {
          out += kReplacement;
          i += 2;
        } else {
          out.push_back(c);
        }
    }
  }
  return out;
}

std::string XmlLiteral(const Term& term) {
  std::string attribute;
  if (!term.language.empty()) {
    attribute = " xml:lang=\"" + XmlText(term.language) + "\"";
  } else if (term.datatype != std::string(kXsd) + "string") {
    attribute = " datatype=\"" + XmlText(term.datatype) + "\"";
  }
  return "<literal" + attribute + ">" + XmlText(term.text) + "</literal>";
}

std::string XmlTerm(const Term& term) {
  if (term.is_iri()) return "<uri>" + XmlText(term.text) + "</uri>";
  if (term.is_blank()) return "<bnode>" + XmlText(term.text) + "</bnode>";
  return XmlLiteral(term);
}

std::string XmlRows(const QueryResult& result) {
  std::string out = "<results>\n";
  for (const auto& row : result.rows) {
    out += "<result>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!row[i]) continue;
      out += "<binding name=\"" + XmlText(result.variables[i]) + "\">" +
             XmlTerm(*row[i]) + "</binding>";
    }
    out += "</result>\n";
  }
  return out + "</results>\n";
}

}  // namespace

std::string ToXml(const QueryResult& given) {
  const QueryResult result = AsRows(given);
  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<sparql xmlns=\"http://www.w3.org/2005/sparql-results#\">\n<head>";
  for (const std::string& name : result.variables) {
    out += "<variable name=\"" + XmlText(name) + "\"/>";
  }
  out += "</head>\n";
  if (result.form == QueryResult::Form::kAsk) {
    out += std::string("<boolean>") + (result.answer ? "true" : "false") +
           "</boolean>\n";
  } else {
    out += XmlRows(result);
  }
  return out + "</sparql>\n";
}

}  // namespace kg_core
