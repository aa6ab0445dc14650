#include "kg_core/rdf/namespaces.h"

#include <algorithm>

namespace kg_core {
namespace {

bool IsLocalChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// A subset of Turtle's PN_LOCAL that needs no escapes in Turtle or SPARQL.
bool IsPlainLocalName(std::string_view name) {
  return !name.empty() && name[0] != '-' &&
         std::all_of(name.begin(), name.end(), IsLocalChar);
}

}  // namespace

std::optional<std::string> ExpandPrefixed(std::string_view prefixed) {
  const std::size_t colon = prefixed.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  for (const NamespacePrefix& prefix : kPrefixes) {
    if (prefixed.substr(0, colon) == prefix.name) {
      return prefix.iri + std::string(prefixed.substr(colon + 1));
    }
  }
  return std::nullopt;
}

std::string AbbreviateIri(std::string_view iri) {
  for (const NamespacePrefix& prefix : kPrefixes) {
    const std::string_view start = prefix.iri;
    if (iri.substr(0, start.size()) != start) continue;
    const std::string_view local = iri.substr(start.size());
    if (IsPlainLocalName(local)) {
      return std::string(prefix.name) + ":" + std::string(local);
    }
  }
  return "<" + std::string(iri) + ">";
}

}  // namespace kg_core
