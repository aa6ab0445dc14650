#include "kg_base/text/iri.h"

#include <cctype>
#include <cstddef>

namespace kg_base {
namespace {

constexpr std::size_t kNpos = std::string_view::npos;

// Components of an IRI, each with its delimiter: scheme "://" authority path
// "?" query "#" fragment.
struct IriParts {
  std::string_view scheme;     // "http:"
  std::string_view authority;  // "//host"
  std::string_view path;
  std::string_view query;     // "?x"
  std::string_view fragment;  // "#y"
};

std::size_t SchemeLength(std::string_view iri) {
  if (iri.empty() || !std::isalpha(static_cast<unsigned char>(iri[0]))) {
    return 0;
  }
  for (std::size_t i = 1; i < iri.size(); ++i) {
    const char c = iri[i];
    if (c == ':') return i + 1;
    const bool fits = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                      c == '+' || c == '-' || c == '.';
    if (!fits) return 0;
  }
  return 0;
}

std::string_view TakeFront(std::string_view* rest, std::size_t length) {
  const std::string_view front = rest->substr(0, length);
  rest->remove_prefix(front.size());
  return front;
}

IriParts Split(std::string_view iri) {
  IriParts parts;
  parts.scheme = TakeFront(&iri, SchemeLength(iri));
  if (iri.substr(0, 2) == "//") {
    { parts.authority = TakeFront(&iri, iri.find_first_of("/?#", 2)); }
  }
  parts.path = TakeFront(&iri, iri.find_first_of("?#"));
  parts.query = TakeFront(&iri, iri.find('#'));
  parts.fragment = iri;
  return parts;
}

// https://www.rfc-editor.org/rfc/rfc3986#section-5.2.4
std::string RemoveDotSegments(std::string_view in) {
  std::string out;
  while (!in.empty()) {
    // The cases A to E of RFC 3986, section 5.2.4.
    if (in.substr(0, 3) == "../") {
      in.remove_prefix(3);
    } else if (in.substr(0, 2) == "./" || in.substr(0, 3) == "/./") {
      in.remove_prefix(2);
    } else if (in == "/.") {
      in = "/";
    } else if (in.substr(0, 4) == "/../" || in == "/..") {
      in = in == "/.." ? std::string_view("/") : in.substr(3);
      const std::size_t slash = out.rfind('/');
      out.erase(slash == kNpos ? 0 : slash);
    } else if (in == "." || in == "..") {
      in = {};
    } else {
      out += TakeFront(&in, in.find('/', 1));
    }
  }
  return out;
}

// https://www.rfc-editor.org/rfc/rfc3986#section-5.2.3
std::string MergePaths(const IriParts& base, std::string_view path) {
  if (!base.authority.empty() && base.path.empty()) {
    return "/" + std::string(path);
  }
  const std::size_t slash = base.path.rfind('/');
  const std::string_view folder =
      slash == kNpos ? std::string_view() : base.path.substr(0, slash + 1);
  return std::string(folder) + std::string(path);
}

std::string Join(std::string_view scheme, std::string_view authority,
                 std::string_view path, std::string_view rest) {
  std::string iri(scheme);
  iri += authority;
  iri += path;
  iri += rest;
  return iri;
}

}  // namespace

bool IsAbsoluteIri(std::string_view iri) { return SchemeLength(iri) > 0; }

std::string ResolveIri(std::string_view base_iri, std::string_view reference) {
  if (base_iri.empty() || IsAbsoluteIri(reference)) {
    return std::string(reference);
  }
  const IriParts base = Split(base_iri);
  const IriParts r = Split(reference);
  const std::string rest = std::string(r.query) + std::string(r.fragment);
  if (!r.authority.empty()) {
    return Join(base.scheme, r.authority, RemoveDotSegments(r.path), rest);
  }
  if (r.path.empty()) {
    const std::string_view query = r.query.empty() ? base.query : r.query;
    return Join(base.scheme, base.authority, base.path,
                std::string(query) + std::string(r.fragment));
  }
  const std::string path =
      r.path[0] == '/' ? std::string(r.path) : MergePaths(base, r.path);
  return Join(base.scheme, base.authority, RemoveDotSegments(path), rest);
}

}  // namespace kg_base
