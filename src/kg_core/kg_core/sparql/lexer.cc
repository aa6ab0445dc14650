#include "kg_core/sparql/lexer.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/text/utf8.h"
#include "kg_core/rdf/term_check.h"

namespace kg_core::sparql {
namespace {

// Longest first, since the first match is taken.
constexpr std::string_view kPunctuation[] = {
    "^^", "&&", "||", "!=", "<=", ">=", "{", "}", "(", ")", "[", "]", ".",
    ";",  ",",  "|",  "/",  "^",  "?",  "*", "+", "-", "!", "=", "<", ">"};

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool IsHex(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }
bool IsMultibyte(char c) { return (c & 0x80) != 0; }
// [164] PN_CHARS_BASE and '_'; all non-ASCII characters are accepted.
bool IsNameStart(char c) { return IsLetter(c) || c == '_' || IsMultibyte(c); }
bool IsNameChar(char c) { return IsNameStart(c) || IsDigit(c) || c == '-'; }

class QueryLexer {
 public:
  explicit QueryLexer(std::string_view text) : text_(text) {}

  std::vector<Token> Run() {
    std::vector<Token> tokens;
    do {
      tokens.push_back(Next());
    } while (tokens.back().kind != Token::Kind::kEnd);
    return tokens;
  }

 private:
  Token Next();
  void SkipBlanks();
  bool ReadIri(Token* token);
  bool ReadName(Token* token);
  void ReadLocalName(Token* token);
  void ReadBlankLabel(Token* token);
  void ReadString(Token* token);
  void ReadNumber(Token* token);
  void ReadDigits(Token* token);
  void ReadPunctuation(Token* token);
  bool ReadVariable(Token* token);
  void ReadLanguageTag(Token* token);
  void ReadStringEscape(std::string* out);
  void ReadCodePoint(std::string* out);
  bool AtCodePoint(std::size_t ahead = 0) const {
    return Peek(ahead) == '\\' &&
           (Peek(ahead + 1) == 'u' || Peek(ahead + 1) == 'U');
  }
  void ReadNameCodePoint(std::string* out);
  std::size_t DottedNameLength(std::size_t start) const;

  char Peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool AtEnd() const { return at_ >= text_.size(); }
  char Take() {
    const char c = text_[at_++];
    if (c == '\n') {
      ++position_.line;
      position_.column = 1;
    } else if ((c & 0xC0) != 0x80) {
      ++position_.column;
    }
    return c;
  }
  void TakeInto(std::string* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out->push_back(Take());
  }
  [[noreturn]] void Fail(const std::string& what) const {
    throw kg_base::InputError(std::to_string(position_.line) + ":" +
                              std::to_string(position_.column) + ": " + what);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  QueryPosition position_;
};

void QueryLexer::SkipBlanks() {
  while (!AtEnd()) {
    const char c = Peek();
    if (c == '#') {
      while (!AtEnd() && Peek() != '\n' && Peek() != '\r') Take();
    } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      Take();
    } else {
      return;
    }
  }
}

Token QueryLexer::Next() {
  SkipBlanks();
  Token token;
  token.position = position_;
  if (AtEnd()) return token;
  const char c = Peek();
  // '<' and '?' are also operators: if no IRI or variable follows, they are
  // read as punctuation.
  if (c == '<' && ReadIri(&token)) return token;
  if ((c == '?' || c == '$') && ReadVariable(&token)) return token;
  if (c == '_' && Peek(1) == ':') {
    ReadBlankLabel(&token);
  } else if (c == '"' || c == '\'') {
    ReadString(&token);
  } else if (IsDigit(c) || (c == '.' && IsDigit(Peek(1)))) {
    ReadNumber(&token);
  } else if (c == '@') {
    ReadLanguageTag(&token);
  } else if (!ReadName(&token)) {
    ReadPunctuation(&token);
  }
  return token;
}

// [139] IRIREF; if no '>' ends it, '<' is an operator.
bool QueryLexer::ReadIri(Token* token) {
  std::size_t end = at_ + 1;
  while (end < text_.size() && text_[end] != '>') {
    const char c = text_[end];
    if (static_cast<unsigned char>(c) <= 0x20 ||
        std::string_view("<\"{}|^`").find(c) != std::string_view::npos) {
      return false;
    }
    ++end;
  }
  // No '>' ahead: '<' is an operator.
  if (end >= text_.size()) return false;
  token->kind = Token::Kind::kIri;
  Take();
  while (Peek() != '>') {
    if (Peek() == '\\') {
      Take();
      ReadCodePoint(&token->text);
    } else {
      token->text.push_back(Take());
    }
  }
  Take();
  // Escapes may not stand for what an IRI may not hold unescaped.
  if (const auto fault = FindIriFault(token->text)) {
    position_ = token->position;
    Fail(*fault);
  }
  return true;
}

// https://www.w3.org/TR/sparql11-query/#codepointEscape, after the backslash.
void QueryLexer::ReadCodePoint(std::string* out) {
  const int digits = Peek() == 'u' ? 4 : Peek() == 'U' ? 8 : 0;
  if (digits == 0) Fail("expected \\u or \\U and hexadecimal digits");
  Take();
  std::uint32_t code = 0;
  for (int i = 0; i < digits; ++i) {
    if (!IsHex(Peek())) Fail("expected a hexadecimal digit");
    const char c = Take();
    const int value = IsDigit(c) ? c - '0' : (c | 0x20) - 'a' + 10;
    code = code * 16 + static_cast<std::uint32_t>(value);
  }
  if (!kg_base::IsUnicodeScalar(code)) Fail("expected the code of a character");
  kg_base::AppendUtf8(code, out);
}

// An escape in a name, from the backslash: it stands for its character.
void QueryLexer::ReadNameCodePoint(std::string* out) {
  std::string character;
  Take();
  ReadCodePoint(&character);
  if (!IsNameChar(character[0])) {
    Fail("expected the code of a character that a name may have");
  }
  *out += character;
}

// [143] VAR1, [144] VAR2
bool QueryLexer::ReadVariable(Token* token) {
  if (!IsNameStart(Peek(1)) && !IsDigit(Peek(1)) && !AtCodePoint(1)) {
    return false;
  }
  token->kind = Token::Kind::kVariable;
  Take();
  while (true) {
    if (IsNameStart(Peek()) || IsDigit(Peek())) {
      token->text.push_back(Take());
    } else if (AtCodePoint()) {
      ReadNameCodePoint(&token->text);
    } else {
      return true;
    }
  }
}

// Number of bytes from `start` that form a name; dots only inside.
std::size_t QueryLexer::DottedNameLength(std::size_t start) const {
  std::size_t end = start;
  while (end < text_.size() && (IsNameChar(text_[end]) || text_[end] == '.')) {
    ++end;
  }
  while (end > start && text_[end - 1] == '.') --end;
  return end - start;
}

// [142] BLANK_NODE_LABEL
void QueryLexer::ReadBlankLabel(Token* token) {
  token->kind = Token::Kind::kBlankLabel;
  Take();
  Take();
  if (!IsNameStart(Peek()) && !IsDigit(Peek())) {
    Fail("expected a blank node label after _:");
  }
  TakeInto(&token->text, DottedNameLength(at_));
}

// A keyword, or [140] PNAME_NS / [141] PNAME_LN.
bool QueryLexer::ReadName(Token* token) {
  const std::size_t length = IsNameStart(Peek()) ? DottedNameLength(at_) : 0;
  const std::size_t after = at_ + length;
  if (after < text_.size() && text_[after] == ':' && Peek() != '_') {
    token->kind = Token::Kind::kPrefixedName;
    TakeInto(&token->prefix, length);
    Take();
    ReadLocalName(token);
    return true;
  }
  if (!IsLetter(Peek())) return false;
  token->kind = Token::Kind::kWord;
  while (IsLetter(Peek()) || IsDigit(Peek()) || Peek() == '_') {
    token->text.push_back(Take());
  }
  return true;
}

// [169] PN_LOCAL with [170] PLX; a final dot ends the triple instead.
void QueryLexer::ReadLocalName(Token* token) {
  std::string* local = &token->text;
  std::size_t dots = 0;  // Pending dots: part of the name only if more follows.
  for (bool first = true;; first = false) {
    const char c = Peek(dots);
    if (!first && c == '.') {
      ++dots;
      continue;
    }
    const bool plain =
        IsNameStart(c) || IsDigit(c) || c == ':' || (c == '-' && !first);
    const bool percent =
        c == '%' && IsHex(Peek(dots + 1)) && IsHex(Peek(dots + 2));
    if (!plain && !percent && c != '\\') return;
    TakeInto(local, dots);
    dots = 0;
    if (percent) TakeInto(local, 3);
    if (plain) TakeInto(local, 1);
    if (c != '\\') continue;
    if (AtCodePoint()) {
      ReadNameCodePoint(local);
      continue;
    }
    Take();
    if (std::string_view("_~.-!$&'()*+,;=/?#@%").find(Peek()) ==
            std::string_view::npos ||
        AtEnd()) {
      Fail("expected a character that a local name may escape");
    }
    TakeInto(local, 1);
  }
}

// [156]-[159] STRING_LITERAL1, 2, LONG1, LONG2
void QueryLexer::ReadString(Token* token) {
  token->kind = Token::Kind::kString;
  const char quote = Peek();
  const bool is_long = Peek(1) == quote && Peek(2) == quote;
  for (int i = 0; i < (is_long ? 3 : 1); ++i) Take();
  while (true) {
    if (AtEnd()) {
      // Report the start of the string, not the end of the text.
      position_ = token->position;
      Fail("this string does not end");
    }
    if (Peek() == quote &&
        (!is_long || (Peek(1) == quote && Peek(2) == quote))) {
      break;
    }
    if (!is_long && (Peek() == '\n' || Peek() == '\r')) {
      Fail("expected the end of the string before the end of the line");
    }
    if (Peek() == '\\') {
      Take();
      ReadStringEscape(&token->text);
    } else {
      token->text.push_back(Take());
    }
  }
  for (int i = 0; i < (is_long ? 3 : 1); ++i) Take();
}

// [160] ECHAR, after the backslash.
void QueryLexer::ReadStringEscape(std::string* out) {
  constexpr std::string_view kFrom = "tbnrf\\\"'";
  constexpr std::string_view kTo = "\t\b\n\r\f\\\"'";
  if (Peek() == 'u' || Peek() == 'U') return ReadCodePoint(out);
  const std::size_t i = AtEnd() ? std::string_view::npos : kFrom.find(Peek());
  if (i == std::string_view::npos) Fail("expected an escape such as \\n");
  Take();
  out->push_back(kTo[i]);
}

void QueryLexer::ReadDigits(Token* token) {
  while (IsDigit(Peek())) token->text.push_back(Take());
}

// [146] INTEGER, [147] DECIMAL, [148] DOUBLE
void QueryLexer::ReadNumber(Token* token) {
  token->kind = Token::Kind::kInteger;
  ReadDigits(token);
  const auto exponent_at = [&](std::size_t ahead) {
    if (Peek(ahead) != 'e' && Peek(ahead) != 'E') return false;
    const char sign = Peek(ahead + 1);
    return IsDigit(sign) ||
           ((sign == '+' || sign == '-') && IsDigit(Peek(ahead + 2)));
  };
  // A '.' not followed by a digit or an exponent ends the triple.
  if (Peek() == '.' && (IsDigit(Peek(1)) || exponent_at(1))) {
    token->kind = Token::Kind::kDecimal;
    TakeInto(&token->text, 1);
    ReadDigits(token);
  }
  if (exponent_at(0)) {
    token->kind = Token::Kind::kDouble;
    TakeInto(&token->text, 2);
    ReadDigits(token);
  }
}

// [145] LANGTAG
void QueryLexer::ReadLanguageTag(Token* token) {
  token->kind = Token::Kind::kLanguageTag;
  Take();
  if (!IsLetter(Peek())) Fail("expected a language tag after @");
  while (IsLetter(Peek()) || IsDigit(Peek()) || Peek() == '-') {
    const char c = Take();
    token->text.push_back(
        static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  }
  if (!IsLanguageTag(token->text)) {
    Fail("language tag @" + token->text +
         "; expected letters, then parts of letters and digits after a '-'");
  }
}

void QueryLexer::ReadPunctuation(Token* token) {
  token->kind = Token::Kind::kPunctuation;
  for (const std::string_view mark : kPunctuation) {
    if (text_.substr(at_, mark.size()) != mark) continue;
    TakeInto(&token->text, mark.size());
    return;
  }
  std::size_t end = at_;
  kg_base::TakeUtf8(text_, &end);
  Fail("unexpected character '" + std::string(text_.substr(at_, end - at_)) +
       "'");
}

}  // namespace

std::vector<Token> Tokenize(std::string_view text) {
  const std::size_t bad = kg_base::FindInvalidUtf8(text);
  if (bad != std::string_view::npos) {
    const std::string_view before = text.substr(0, bad);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n') + 1;
    throw kg_base::InputError(
        std::to_string(line) + ":" +
        std::to_string(kg_base::Utf8Length(before.substr(start)) + 1) +
        ": this is not UTF-8");
  }
  return QueryLexer(text).Run();
}

}  // namespace kg_core::sparql
