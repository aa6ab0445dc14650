#include "kg_engine/conformance/documents.h"

#include <filesystem>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/conformance/read_rdf_xml.h"

namespace kg_engine::conformance {
namespace {

using kg_core::Iri;
using kg_core::Term;

constexpr char kScheme[] = "file://";
constexpr std::size_t kMaxBytes = 64u << 20;

bool IsPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') ||
         std::string_view("/-._~").find(c) != std::string_view::npos;
}

int HexValue(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

}  // namespace

std::string EscapeUrl(const std::string& text) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string url;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (IsPlain(c)) {
      url += c;
    } else {
      url += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return url;
}

std::string UrlOfPath(const std::string& path) {
  return kScheme + EscapeUrl(path);
}

std::string PathOfUrl(const std::string& url) {
  const std::string scheme = kScheme;
  if (url.compare(0, scheme.size(), scheme) != 0) {
    throw NotRun("needs <" + url + "> from the network");
  }
  std::string path;
  for (std::size_t at = scheme.size(); at < url.size(); ++at) {
    const int high = at + 2 < url.size() ? HexValue(url[at + 1]) : -1;
    const int low = at + 2 < url.size() ? HexValue(url[at + 2]) : -1;
    if (url[at] == '%' && high >= 0 && low >= 0) {
      path += static_cast<char>(high * 16 + low);
      at += 2;
    } else {
      path += url[at];
    }
  }
  return path;
}

std::string GetText(const std::string& url) {
  return kg_base::ReadFile(PathOfUrl(url), kMaxBytes);
}

std::vector<kg_core::Statement> CollectStatements(const std::string& url,
                                                  const std::string& graph) {
  const std::string path = PathOfUrl(url);
  const std::string suffix = std::filesystem::path(path).extension();
  const kg_core::RdfSource source{path, Iri(graph), url};
  if (suffix == ".rdf" || suffix == ".owl" || suffix == ".xml") {
    return ParseRdfXml(GetText(url), source);
  }
  const kg_core::RdfSyntaxName* syntax = kg_core::SyntaxOfPath(path);
  return kg_core::ParseRdf(
      GetText(url),
      syntax == nullptr ? kg_core::RdfSyntax::kTurtle : syntax->syntax, source);
}

void DocumentStore::Load(const std::string& url) {
  if (!loaded_.insert(url).second) return;
  kg_core::Transaction change = store_.Begin();
  for (const kg_core::Statement& s : CollectStatements(url, url)) change.Add(s);
  change.Commit(kg_core::WorldChange::kNo);
  view_ = store_.Read();
}

std::vector<Term> DocumentStore::All(const std::string& graph,
                                     const Term& subject,
                                     const std::string& property) const {
  return kg_core::Objects(*view_, graph, subject, Iri(property));
}

std::optional<Term> DocumentStore::One(const std::string& graph,
                                       const Term& subject,
                                       const std::string& property) const {
  return kg_core::FirstObject(*view_, graph, subject, Iri(property));
}

std::vector<Term> DocumentStore::OfType(const std::string& graph,
                                        const std::string& type) const {
  return kg_core::Subjects(*view_, graph,
                           Iri(std::string(kg_core::kRdf) + "type"), Iri(type));
}

}  // namespace kg_engine::conformance
