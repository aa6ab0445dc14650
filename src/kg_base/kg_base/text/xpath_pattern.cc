#include "kg_base/text/xpath_pattern.h"

#include <unicode/uchar.h>
#include <unicode/uniset.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "absl/strings/ascii.h"
#include "kg_base/text/utf8.h"

namespace kg_base {
namespace {

// Nested class subtractions, which the translator recurses into.
constexpr int kMaxSubtractions = 50;

struct InvalidPattern {};

std::string FormatCodePoint(std::uint32_t code) {
  char text[16];
  std::snprintf(text, sizeof text, "\\x{%X}", static_cast<unsigned>(code));
  return text;
}

// What a class escape stands for, as PCRE2 writes it within brackets. \w is all
// but punctuation, separators and "other" characters.
struct ClassEscape {
  char letter;
  const char* members;
};
constexpr ClassEscape kClassEscapes[] = {
    {'d', "\\p{Nd}"},
    {'D', "\\P{Nd}"},
    {'s', "\\x{20}\\t\\n\\r"},
    {'S', "\\x{0}-\\x{8}\\x{B}\\x{C}\\x{E}-\\x{1F}\\x{21}-\\x{10FFFF}"},
    {'w', "\\p{L}\\p{M}\\p{N}\\p{S}"},
    {'W', "\\p{P}\\p{Z}\\p{C}"},
};

struct CodeRange {
  std::uint32_t first, last;
};
// https://www.w3.org/TR/xml/#NT-NameStartChar
constexpr CodeRange kNameStarts[] = {
    {':', ':'},       {'A', 'Z'},       {'_', '_'},       {'a', 'z'},
    {0xC0, 0xD6},     {0xD8, 0xF6},     {0xF8, 0x2FF},    {0x370, 0x37D},
    {0x37F, 0x1FFF},  {0x200C, 0x200D}, {0x2070, 0x218F}, {0x2C00, 0x2FEF},
    {0x3001, 0xD7FF}, {0xF900, 0xFDCF}, {0xFDF0, 0xFFFD}, {0x10000, 0xEFFFF},
};
// What https://www.w3.org/TR/xml/#NT-NameChar has besides.
constexpr CodeRange kNameOthers[] = {
    {'-', '.'}, {'0', '9'}, {0xB7, 0xB7}, {0x300, 0x36F}, {0x203F, 0x2040}};

// The set within brackets, without surrogates, which PCRE2 refuses.
std::string FormatMembers(icu::UnicodeSet set, bool is_complement) {
  if (is_complement) set.complement();
  set.remove(0xD800, 0xDFFF);
  std::string text;
  for (std::int32_t i = 0; i < set.getRangeCount(); ++i) {
    text += FormatCodePoint(static_cast<std::uint32_t>(set.getRangeStart(i))) +
            "-" +
            FormatCodePoint(static_cast<std::uint32_t>(set.getRangeEnd(i)));
  }
  if (text.empty()) throw InvalidPattern();
  return text;
}

// \i, \I, \c and \C
std::string GetNameMembers(char letter) {
  icu::UnicodeSet set;
  for (const CodeRange& range : kNameStarts) {
    set.add(static_cast<UChar32>(range.first),
            static_cast<UChar32>(range.last));
  }
  if (letter == 'i' || letter == 'I') return FormatMembers(set, letter == 'I');
  for (const CodeRange& range : kNameOthers) {
    set.add(static_cast<UChar32>(range.first),
            static_cast<UChar32>(range.last));
  }
  return FormatMembers(set, letter == 'C');
}

// The general categories of XML Schema, which has no Cs.
constexpr std::string_view kCategories[] = {
    "L",  "Lu", "Ll", "Lt", "Lm", "Lo", "M",  "Mn", "Mc", "Me", "N",  "Nd",
    "Nl", "No", "P",  "Pc", "Pd", "Ps", "Pe", "Pi", "Pf", "Po", "Z",  "Zs",
    "Zl", "Zp", "S",  "Sm", "Sc", "Sk", "So", "C",  "Cc", "Cf", "Co", "Cn"};

// The characters of a block ("BasicLatin").
std::string GetBlockMembers(const std::string& name, bool is_complement) {
  const std::int32_t block = u_getPropertyValueEnum(UCHAR_BLOCK, name.c_str());
  if (block == UCHAR_INVALID_CODE) throw InvalidPattern();
  UErrorCode status = U_ZERO_ERROR;
  icu::UnicodeSet set;
  set.applyIntPropertyValue(UCHAR_BLOCK, block, status);
  if (U_FAILURE(status) != 0) throw InvalidPattern();
  return FormatMembers(set, is_complement);
}

class PatternTranslator {
 public:
  explicit PatternTranslator(std::string_view pattern) : rest_(pattern) {}

  std::string Run() {
    while (!rest_.empty()) TranslateNext();
    if (open_groups_ > 0) throw InvalidPattern();
    return std::move(out_);
  }

 private:
  char Peek(std::size_t ahead = 0) const {
    return ahead < rest_.size() ? rest_[ahead] : '\0';
  }
  bool TakeMark(std::string_view mark) {
    if (rest_.substr(0, mark.size()) != mark) return false;
    rest_.remove_prefix(mark.size());
    return true;
  }
  char Take() {
    if (rest_.empty()) throw InvalidPattern();
    const char c = rest_[0];
    rest_.remove_prefix(1);
    return c;
  }
  std::uint32_t TakeCharacter() {
    if (rest_.empty()) throw InvalidPattern();
    std::size_t length = 0;
    const std::uint32_t code = TakeUtf8(rest_, &length);
    rest_.remove_prefix(length);
    return code;
  }

  // One atom, anchor, branch mark or bracket of a group.
  void TranslateNext() {
    switch (Peek()) {
      case '(':
        return OpenGroup();
      case ')':
        return CloseGroup();
      case '|':
      case '^':
      case '$':
        out_.push_back(Take());
        return;
      case '[':
        out_ += TakeClass(0);
        break;
      case '\\':
        out_ += TakeEscape();
        break;
      case '.':
        out_.push_back(Take());
        break;
      case '?':
      case '*':
      case '+':
      case '{':
      case '}':
      case ']':
        throw InvalidPattern();
      default:
        out_ += FormatLiteral(TakeCharacter());
    }
    TakeQuantifier();
  }

  static std::string FormatLiteral(std::uint32_t code) {
    const bool is_word =
        code < 0x80 && absl::ascii_isalnum(static_cast<unsigned char>(code));
    return is_word ? std::string(1, static_cast<char>(code))
                   : FormatCodePoint(code);
  }

  void OpenGroup() {
    Take();
    ++open_groups_;
    const bool captures = !TakeMark("?:");
    if (captures) ++groups_;
    group_numbers_.push_back(captures ? groups_ : 0);
    out_ += captures ? "(" : "(?:";
  }

  void CloseGroup() {
    if (open_groups_ == 0) throw InvalidPattern();
    Take();
    --open_groups_;
    const int number = group_numbers_.back();
    group_numbers_.pop_back();
    if (number > 0) closed_groups_.push_back(number);
    out_.push_back(')');
    TakeQuantifier();
  }

  // [4] quantifier with XPath's '?' for the shortest match.
  void TakeQuantifier() {
    const char c = Peek();
    if (c == '{') {
      TakeBounds();
    } else if (c == '?' || c == '*' || c == '+') {
      out_.push_back(Take());
    } else {
      return;
    }
    if (TakeMark("?")) out_.push_back('?');
    const char next = Peek();
    if (next == '?' || next == '*' || next == '+' || next == '{') {
      throw InvalidPattern();
    }
  }

  // {n}, {n,} or {n,m}
  void TakeBounds() {
    out_.push_back(Take());
    TakeDigits();
    if (TakeMark(",")) {
      out_.push_back(',');
      if (Peek() != '}') TakeDigits();
    }
    if (!TakeMark("}")) throw InvalidPattern();
    out_.push_back('}');
  }

  void TakeDigits() {
    if (!absl::ascii_isdigit(Peek())) throw InvalidPattern();
    while (absl::ascii_isdigit(Peek())) out_.push_back(Take());
  }

  // An escape outside of brackets.
  std::string TakeEscape() {
    if (absl::ascii_isdigit(Peek(1))) return TakeBackReference();
    if (const auto members = TakeClassEscape()) return "[" + *members + "]";
    return FormatCodePoint(TakeCharacterEscape());
  }

  // As many digits as there are groups for; the group must be complete.
  std::string TakeBackReference() {
    Take();
    int number = Take() - '0';
    while (absl::ascii_isdigit(Peek()) &&
           10 * number + (Peek() - '0') <= groups_) {
      number = 10 * number + (Take() - '0');
    }
    const bool is_closed =
        std::find(closed_groups_.begin(), closed_groups_.end(), number) !=
        closed_groups_.end();
    if (!is_closed) throw InvalidPattern();
    return "\\g{" + std::to_string(number) + "}";
  }

  // [23] charClassEsc: the characters of an escape for more than one.
  std::optional<std::string> TakeClassEscape() {
    const char letter = Peek(1);
    if (letter == 'p' || letter == 'P') return TakeProperty();
    if (letter != '\0' &&
        std::string_view("iIcC").find(letter) != std::string_view::npos) {
      rest_.remove_prefix(2);
      return GetNameMembers(letter);
    }
    for (const ClassEscape& escape : kClassEscapes) {
      if (escape.letter != letter) continue;
      rest_.remove_prefix(2);
      return escape.members;
    }
    return std::nullopt;
  }

  // \p{Lu}, \P{IsGreek}
  std::string TakeProperty() {
    Take();
    const char letter = Take();
    if (!TakeMark("{")) throw InvalidPattern();
    const std::string name(rest_.substr(0, rest_.find('}')));
    rest_.remove_prefix(name.size());
    if (!TakeMark("}")) throw InvalidPattern();
    if (name.rfind("Is", 0) == 0) {
      return GetBlockMembers(name.substr(2), letter == 'P');
    }
    if (std::find(std::begin(kCategories), std::end(kCategories), name) ==
        std::end(kCategories)) {
      throw InvalidPattern();
    }
    return std::string("\\") + letter + "{" + name + "}";
  }

  // [24] SingleCharEsc
  std::uint32_t TakeCharacterEscape() {
    Take();
    const char c = Take();
    if (c == 'n') return '\n';
    if (c == 'r') return '\r';
    if (c == 't') return '\t';
    if (std::string_view("\\|.?*+(){}-[]^$").find(c) ==
        std::string_view::npos) {
      throw InvalidPattern();
    }
    return static_cast<unsigned char>(c);
  }

  // [11] charClassExpr; a subtraction is a lookahead before the class.
  std::string TakeClass(int nesting) {
    if (nesting > kMaxSubtractions) throw InvalidPattern();
    Take();
    const std::string begin = TakeMark("^") ? "[^" : "[";
    std::string members;
    while (!TakeMark("]")) {
      if (!members.empty() && rest_.substr(0, 2) == "-[") {
        Take();
        const std::string subtracted = TakeClass(nesting + 1);
        if (!TakeMark("]")) throw InvalidPattern();
        return std::string("(?:(?!")
            .append(subtracted)
            .append(")")
            .append(begin)
            .append(members)
            .append("])");
      }
      members += TakeClassPart();
    }
    if (members.empty()) throw InvalidPattern();
    return begin + members + "]";
  }

  // [14] posCharGroup: a range, a character or an escape.
  std::string TakeClassPart() {
    if (Peek() == '\\') {
      if (const auto members = TakeClassEscape()) return *members;
    }
    const std::string first = FormatCodePoint(TakeClassCharacter());
    // A '-' before the end or a subtraction is a character.
    if (Peek() != '-' || Peek(1) == ']' || Peek(1) == '[') return first;
    Take();
    return first + "-" + FormatCodePoint(TakeClassCharacter());
  }

  std::uint32_t TakeClassCharacter() {
    if (Peek() == '\\') return TakeCharacterEscape();
    if (Peek() == '[' || Peek() == ']') throw InvalidPattern();
    return TakeCharacter();
  }

  std::string_view rest_;
  std::string out_;
  int groups_ = 0;  // Groups opened so far that capture.
  int open_groups_ = 0;
  std::vector<int> group_numbers_;  // Of the open ones; 0: does not capture.
  std::vector<int> closed_groups_;
};

}  // namespace

std::optional<std::string> ToPcrePattern(std::string_view pattern) {
  try {
    return PatternTranslator(pattern).Run();
  } catch (const InvalidPattern&) {
    return std::nullopt;
  }
}

}  // namespace kg_base
