#include "kg_engine/protocol/write_rdf_xml.h"

#include <cstddef>

#include "kg_core/rdf/namespaces.h"
#include "kg_engine/protocol/http.h"

namespace kg_engine {
namespace {

using kg_core::Triple;

std::string Escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\t' &&
                            c != '\n' && c != '\r';
    if (is_control) {
      throw HttpError(kNotAcceptable,
                      "RDF/XML cannot hold a control character; ask for "
                      "text/turtle");
    }
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\r') {
      out += "&#13;";  // A reader would convert it to a line feed.
    } else {
      out.push_back(c);
    }
  }
  return out;
}

bool IsXmlNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool IsXmlNameChar(char c) {
  return IsXmlNameStart(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

// Position of the longest XML name at the end of an IRI.
std::size_t LocalNameAt(const std::string& iri) {
  std::size_t begin = iri.size();
  for (std::size_t i = iri.size(); i > 0 && IsXmlNameChar(iri[i - 1]); --i) {
    if (IsXmlNameStart(iri[i - 1])) begin = i - 1;
  }
  if (begin < iri.size() && begin > 0) return begin;
  throw HttpError(kNotAcceptable, "RDF/XML cannot name the predicate <" + iri +
                                      ">; ask for text/turtle");
}

// NCNames may not begin with a digit, labels may.
std::string NodeAttribute(const kg_core::Term& node,
                          const char* iri_attribute) {
  if (node.is_blank()) return " rdf:nodeID=\"n" + Escape(node.text) + "\"";
  return std::string(" ") + iri_attribute + "=\"" + Escape(node.text) + "\"";
}

std::string Property(const Triple& triple) {
  const std::string& iri = triple.predicate.text;
  const std::size_t at = LocalNameAt(iri);
  const std::string name = "p:" + iri.substr(at);
  const std::string open =
      "    <" + name + " xmlns:p=\"" + Escape(iri.substr(0, at)) + "\"";
  const kg_core::Term& object = triple.object;
  if (!object.is_literal()) {
    return open + NodeAttribute(object, "rdf:resource") + "/>\n";
  }
  std::string kind;
  if (!object.language.empty()) {
    kind = " xml:lang=\"" + object.language + "\"";
  } else if (object.datatype != std::string(kg_core::kXsd) + "string") {
    kind = " rdf:datatype=\"" + Escape(object.datatype) + "\"";
  }
  return open + kind + ">" + Escape(object.text) + "</" + name + ">\n";
}

}  // namespace

std::string TriplesToRdfXml(const std::vector<Triple>& triples) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<rdf:RDF ";
  out += std::string("xmlns:rdf=\"") + kg_core::kRdf + "\">\n";
  for (const Triple& triple : triples) {
    out += "  <rdf:Description" + NodeAttribute(triple.subject, "rdf:about") +
           ">\n" + Property(triple) + "  </rdf:Description>\n";
  }
  return out + "</rdf:RDF>\n";
}

}  // namespace kg_engine
