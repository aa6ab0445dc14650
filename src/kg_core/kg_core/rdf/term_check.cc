#include "kg_core/rdf/term_check.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "absl/strings/ascii.h"
#include "kg_base/common/text.h"
#include "kg_base/text/iri.h"

namespace kg_core {
namespace {

constexpr char kLangString[] =
    "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString";

// By byte: may it not stand in an IRI?
// https://www.w3.org/TR/n-triples/#grammar-production-IRIREF
constexpr std::array<bool, 256> MakeForbidden() {
  std::array<bool, 256> forbidden{};
  for (std::size_t c = 0; c <= 0x20; ++c) forbidden[c] = true;
  for (const char c : std::string_view("<>\"{}|^`\\")) {
    forbidden[static_cast<unsigned char>(c)] = true;
  }
  return forbidden;
}
constexpr std::array<bool, 256> kForbiddenInIri = MakeForbidden();

std::string FormatCode(char c) {
  char code[8];
  std::snprintf(code, sizeof code, "U+%04X",
                static_cast<unsigned>(static_cast<unsigned char>(c)));
  return code;
}

std::optional<std::string> FindAbsoluteIriFault(std::string_view iri) {
  if (auto fault = FindIriFault(iri)) return fault;
  if (kg_base::IsAbsoluteIri(iri)) return std::nullopt;
  return "relative IRI <" + std::string(iri) + ">; expected an absolute IRI";
}

std::optional<std::string> FindLiteralFault(const Term& term) {
  if (kg_base::FirstBadUtf8(term.text)) {
    return "text with a surrogate or bytes that are not UTF-8; expected "
           "Unicode "
           "characters";
  }
  if (term.language.empty()) {
    if (term.datatype == kLangString) {
      return "rdf:langString without a language; expected a language tag";
    }
    return FindAbsoluteIriFault(term.datatype);
  }
  if (IsLanguageTag(term.language)) return std::nullopt;
  return "language tag '" + term.language +
         "'; expected letters, then parts of letters and digits after a '-'";
}

}  // namespace

std::optional<std::string> FindIriFault(std::string_view reference) {
  const auto forbidden = std::find_if(
      reference.begin(), reference.end(),
      [](char c) { return kForbiddenInIri[static_cast<unsigned char>(c)]; });
  if (forbidden != reference.end()) {
    return "IRI with the character " + FormatCode(*forbidden) +
           "; expected only characters that an IRI may hold";
  }
  if (!kg_base::FirstBadUtf8(reference)) return std::nullopt;
  return "IRI with a surrogate or bytes that are not UTF-8; expected Unicode "
         "characters";
}

// [144s] LANGTAG
bool IsLanguageTag(std::string_view text) {
  std::size_t part = 0;    // Characters of this part so far.
  bool is_primary = true;  // The first part has letters only.
  for (const char c : text) {
    if (c == '-') {
      if (part == 0) return false;
      part = 0;
      is_primary = false;
      continue;
    }
    const bool fits =
        absl::ascii_isalpha(c) || (absl::ascii_isdigit(c) && !is_primary);
    if (!fits) return false;
    ++part;
  }
  return part > 0;
}

std::optional<std::string> FindTermFault(const Term& term) {
  switch (term.kind) {
    case Term::Kind::kIri:
      return FindAbsoluteIriFault(term.text);
    case Term::Kind::kLiteral:
      return FindLiteralFault(term);
    case Term::Kind::kBlank:
      break;
  }
  return std::nullopt;
}

}  // namespace kg_core
