// Parser for exactly one RDF term in Turtle's term syntax, so that a message
// field can never smuggle in more than one term.
// https://www.w3.org/TR/turtle/#sec-grammar-grammar

#include <string>
#include <string_view>

#include "absl/strings/ascii.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {
namespace {

int HexValue(char c) {
  if (absl::ascii_isdigit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// All non-ASCII characters are accepted in a name: Turtle excludes only some
// punctuation there, none of which is syntax.
bool IsNameChar(char c) {
  return absl::ascii_isalpha(c) || absl::ascii_isdigit(c) || c == '_' ||
         c == '-' || static_cast<unsigned char>(c) >= 0x80;
}

bool IsForbiddenInIri(unsigned char c) {
  return c <= 0x20 ||
         std::string_view("<>\"{}|^`\\").find(static_cast<char>(c)) !=
             std::string_view::npos;
}

// The text as one line of at most 80 bytes, for messages.
std::string Shown(std::string_view text) {
  std::string shown;
  for (const char c : kg_base::FirstCharacters(text, 80)) {
    shown.push_back(static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
  }
  return "'" + shown + (text.size() > 80 ? "..." : "") + "'";
}

class TermParser {
 public:
  explicit TermParser(std::string_view text)
      : text_(text), rest_(kg_base::StripAsciiSpace(text)) {}

  Term Parse() {
    if (const auto bad = kg_base::FirstBadUtf8(text_)) {
      Refuse("it is not UTF-8");
    }
    if (rest_.empty()) Refuse("it is empty");
    Term term = ParseTerm();
    if (!rest_.empty()) Refuse("there is more after it: " + Shown(rest_));
    return term;
  }

 private:
  Term ParseTerm() {
    const char c = rest_[0];
    if (c == '<') return Iri(ParseIri());
    if (c == '"' || c == '\'') return ParseQuoted();
    if (rest_.substr(0, 2) == "_:") return ParseBlank();
    if (absl::ascii_isdigit(c) || c == '+' || c == '-' || c == '.') {
      return ParseBare();
    }
    if (rest_ == "true" || rest_ == "false") return ParseBare();
    return Iri(ParsePrefixedName());
  }

  // A number or boolean, which must be the whole rest of the text. ToTurtle
  // decides which datatypes may be written without quotes, and in which form.
  Term ParseBare() {
    for (const char* type : {"integer", "decimal", "double", "boolean"}) {
      Term term = Literal(std::string(rest_), std::string(kXsd) + type);
      if (ToTurtle(term) != rest_) continue;
      rest_ = {};
      return term;
    }
    Refuse("it is not a number");
  }

  Term ParseBlank() {
    rest_.remove_prefix(2);
    std::string label = TakeName();
    if (label.empty() || label[0] == '-') Refuse("the label is malformed");
    return Blank(std::move(label));
  }

  // Consumes name characters, with dots inside but not at either end.
  std::string TakeName() {
    std::size_t end = 0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (IsNameChar(rest_[i])) {
        end = i + 1;
      } else if (rest_[i] != '.' || i == 0) {
        break;
      }
    }
    std::string name(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return name;
  }

  std::string ParsePrefixedName() {
    const std::size_t colon = rest_.find(':');
    const std::string prefix(rest_.substr(0, colon));
    for (const char c : prefix) {
      if (!IsNameChar(c) && c != '.') Refuse("it does not start like a term");
    }
    if (colon == std::string_view::npos) Refuse("it has no prefix");
    const auto start = ExpandPrefixed(prefix + ":");
    if (!start) Refuse("its prefix '" + prefix + ":' is unknown");
    rest_.remove_prefix(colon + 1);
    return *start + TakeLocalName();
  }

  std::string TakeLocalName() {
    std::string local;
    bool ends_with_dot = false;
    while (!rest_.empty()) {
      const char c = rest_[0];
      // A local name may contain '.' but not start with '.' or '-'.
      const bool plain = IsNameChar(c) || c == ':';
      const bool dot = c == '.' && !local.empty();
      if (c == '\\') {
        TakeLocalEscape(&local);
      } else if (c == '%') {
        TakePercent(&local);
      } else if ((plain && !(c == '-' && local.empty())) || dot) {
        local.push_back(Take());
      } else {
        break;
      }
      ends_with_dot = dot;
    }
    if (ends_with_dot) Refuse("a name cannot end with '.'");
    return local;
  }

  void TakeLocalEscape(std::string* local) {
    constexpr std::string_view kEscapable = "_~.-!$&'()*+,;=/?#@%";
    if (rest_.size() < 2 || kEscapable.find(rest_[1]) == kEscapable.npos) {
      Refuse("it has a malformed escape");
    }
    local->push_back(rest_[1]);
    rest_.remove_prefix(2);
  }

  void TakePercent(std::string* local) {
    const bool valid =
        rest_.size() >= 3 && HexValue(rest_[1]) >= 0 && HexValue(rest_[2]) >= 0;
    if (!valid) Refuse("'%' needs two hexadecimal digits");
    *local += rest_.substr(0, 3);
    rest_.remove_prefix(3);
  }

  std::string ParseIri() {
    Take();
    std::string iri;
    while (!rest_.empty() && rest_[0] != '>') {
      if (rest_[0] == '\\') {
        const std::size_t start = iri.size();
        TakeCodeEscape(&iri);
        if (IsForbiddenInIri(iri[start])) Refuse("its IRI is malformed");
      } else if (IsForbiddenInIri(rest_[0])) {
        Refuse("its IRI is malformed");
      } else {
        iri.push_back(Take());
      }
    }
    if (rest_.empty()) Refuse("'>' is missing");
    Take();
    CheckAbsolute(iri);
    return iri;
  }

  void CheckAbsolute(const std::string& iri) const {
    const std::string scheme = iri.substr(0, iri.find(':'));
    bool valid = scheme.size() < iri.size() && absl::ascii_isalpha(iri[0]);
    for (const char c : scheme) {
      valid &= absl::ascii_isalpha(c) || absl::ascii_isdigit(c) || c == '+' ||
               c == '-' || c == '.';
    }
    if (!valid) Refuse("its IRI is not absolute");
  }

  Term ParseQuoted() {
    const char quote = rest_[0];
    const bool is_long = rest_.substr(0, 3) == std::string(3, quote);
    const std::string end(is_long ? 3 : 1, quote);
    rest_.remove_prefix(end.size());
    std::string text = TakeStringBody(end);
    rest_.remove_prefix(end.size());
    if (rest_.substr(0, 1) == "@") {
      return LanguageLiteral(std::move(text), TakeLanguage());
    }
    if (rest_.substr(0, 2) != "^^") return Literal(std::move(text));
    rest_.remove_prefix(2);
    if (rest_.empty()) Refuse("the datatype is missing");
    return Literal(std::move(text),
                   rest_[0] == '<' ? ParseIri() : ParsePrefixedName());
  }

  std::string TakeStringBody(const std::string& end) {
    std::string text;
    while (rest_.substr(0, end.size()) != end) {
      if (rest_.empty()) Refuse("the closing quote is missing");
      if (rest_[0] == '\\') {
        TakeStringEscape(&text);
      } else if (end.size() == 1 && (rest_[0] == '\n' || rest_[0] == '\r')) {
        Refuse("a line ends inside its quotes");
      } else {
        text.push_back(Take());
      }
    }
    return text;
  }

  void TakeStringEscape(std::string* text) {
    constexpr std::string_view kLetters = "tbnrf\"'\\";
    constexpr std::string_view kMeanings = "\t\b\n\r\f\"'\\";
    const std::size_t which =
        rest_.size() < 2 ? kLetters.npos : kLetters.find(rest_[1]);
    if (which == kLetters.npos) {
      TakeCodeEscape(text);
    } else {
      text->push_back(kMeanings[which]);
      rest_.remove_prefix(2);
    }
  }

  // \uXXXX or \UXXXXXXXX.
  void TakeCodeEscape(std::string* text) {
    const char kind = rest_.size() < 2 ? '\0' : rest_[1];
    const std::size_t digits = kind == 'u' ? 4 : kind == 'U' ? 8 : 0;
    if (digits == 0 || rest_.size() < 2 + digits) {
      Refuse("it has a malformed escape");
    }
    std::uint32_t code = 0;
    for (const char c : rest_.substr(2, digits)) {
      if (HexValue(c) < 0) Refuse("it has a malformed escape");
      code = code * 16 + HexValue(c);
    }
    if (!kg_base::IsUnicodeScalar(code)) {
      Refuse("it escapes a code that is not a character");
    }
    kg_base::AppendUtf8(code, text);
    rest_.remove_prefix(2 + digits);
  }

  std::string TakeLanguage() {
    Take();
    std::string tag;
    bool in_first = true;
    while (!rest_.empty()) {
      const char c = rest_[0];
      if (c == '-' && !tag.empty() && tag.back() != '-') {
        in_first = false;
      } else if (!absl::ascii_isalpha(c) &&
                 (in_first || !absl::ascii_isdigit(c))) {
        break;
      }
      tag.push_back(Take());
    }
    if (tag.empty() || tag.back() == '-') Refuse("its language is malformed");
    return tag;
  }

  char Take() {
    const char c = rest_[0];
    rest_.remove_prefix(1);
    return c;
  }

  [[noreturn]] void Refuse(const std::string& why) const {
    throw kg_base::InputError(
        Shown(text_) + " is not one term: " + why +
        "; expected an IRI (ex:alpha, <http://...>), a literal (\"x\", "
        "\"x\"@en, \"1\"^^xsd:byte, 0.4, 3, true) or a blank node (_:b0)");
  }

  const std::string_view text_;
  std::string_view rest_;
};

}  // namespace

Term ParseTurtleTerm(std::string_view text) { return TermParser(text).Parse(); }

}  // namespace kg_core
