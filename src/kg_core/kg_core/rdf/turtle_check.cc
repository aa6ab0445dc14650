#include "kg_core/rdf/turtle_check.h"

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_core {
namespace {

using kg_base::InputError;

// Characters of a prefixed name or a label. All non-ASCII characters are
// accepted: Turtle excludes only some punctuation there, none of which is
// syntax.
bool IsNameOrLabelChar(char c) {
  return absl::ascii_isalpha(c) || absl::ascii_isdigit(c) || c == '_' ||
         c == '-' || c == ':' || c == '%' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool IsTurtleSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

// Scans the tokens. Only token boundaries matter here; serd checks the grammar.
class TurtleScanner {
 public:
  TurtleScanner(std::string_view text, RdfSyntax syntax,
                const std::string& source, int max_nesting)
      : text_(text),
        source_(source),
        has_braces_(syntax == RdfSyntax::kTriG),
        is_lines_(syntax == RdfSyntax::kNTriples ||
                  syntax == RdfSyntax::kNQuads),
        max_nesting_(max_nesting) {}

  std::vector<InsertedByte> Run() {
    while (at_ < text_.size()) {
      if (is_lines_) FollowLine();
      Step();
    }
    if (is_lines_) EndLine();
    return std::move(inserted_);
  }

 private:
  char At(std::size_t offset) const {
    return offset < text_.size() ? text_[offset] : '\0';
  }

  void Step() {
    const char c = text_[at_];
    // A comment extends to the end of its line, an IRI to '>' on the same line.
    if (c == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (c == '<') {
      at_ = std::min(text_.find_first_of(">\n", at_ + 1), text_.size() - 1) + 1;
    } else if (c == '"' || c == '\'') {
      SkipString();
    } else if (c == '@') {
      for (++at_; absl::ascii_isalpha(At(at_)) ||
                  absl::ascii_isdigit(At(at_)) || At(at_) == '-';) {
        ++at_;
      }
    } else if (c == '_' && At(at_ + 1) == ':') {
      at_ += 2;
      inserted_.push_back({at_, 'u'});
      SkipName();
    } else if (absl::ascii_isdigit(c) || c == '+' || c == '-') {
      SkipNumber();
    } else if (IsNameOrLabelChar(c)) {
      SkipName();
    } else {
      CountBracket(c);
      ++at_;
    }
  }

  void CountBracket(char c) {
    if ((c == '{' || c == '}') && !has_braces_) RefuseBrace();
    if (c == '[' || c == '(') {
      if (++nesting_ > max_nesting_) RefuseNesting();
    } else if ((c == ']' || c == ')') && nesting_ > 0) {
      --nesting_;
    }
  }

  void SkipString() {
    const char quote = text_[at_];
    const bool is_long = text_.substr(at_, 3) == std::string(3, quote);
    const std::string end(is_long && !is_lines_ ? 3 : 1, quote);
    at_ += end.size();
    while (at_ < text_.size() && text_.substr(at_, end.size()) != end) {
      if (end.size() == 1 && text_[at_] == '\n') return;
      at_ += text_[at_] == '\\' ? 2 : 1;
    }
    at_ = std::min(at_ + end.size(), text_.size());
  }

  // A '.' belongs to a name only if more of the name follows; a character after
  // a backslash is never syntax.
  void SkipName() {
    while (at_ < text_.size()) {
      std::size_t next = at_;
      while (At(next) == '.') ++next;
      if (At(next) == '\\' && !is_lines_) {
        at_ = std::min(next + 2, text_.size());
      } else if (IsNameOrLabelChar(At(next))) {
        at_ = next + 1;
      } else {
        return;
      }
    }
  }

  // [19] INTEGER, [20] DECIMAL or [21] DOUBLE up to its exponent. The point of
  // a double may be followed by the exponent ("1.e3"); other points without a
  // digit behind them end the statement.
  void SkipNumber() {
    bool has_point = false;
    for (++at_; absl::ascii_isdigit(At(at_)) ||
                (At(at_) == '.' && absl::ascii_isdigit(At(at_ + 1)));
         ++at_) {
      has_point |= At(at_) == '.';
    }
    const bool is_integer =
        !has_point && At(at_) == '.' && !IsExponent(at_ + 1);
    if (is_integer) inserted_.push_back({at_, ' '});
  }

  bool IsExponent(std::size_t at) const {
    if (At(at) != 'e' && At(at) != 'E') return false;
    const bool has_sign = At(at + 1) == '+' || At(at + 1) == '-';
    return absl::ascii_isdigit(At(at + (has_sign ? 2 : 1)));
  }

  // Checks the line syntaxes: one statement per line, ended by '.', without
  // abbreviated terms.
  void FollowLine() {
    const char c = text_[at_];
    if (c == '\n') EndLine();
    if (IsTurtleSpace(c) || c == '#') return;
    if (line_is_ended_) Refuse("expected the end of the line");
    const bool is_term = c == '<' || c == '"' || c == '_';
    if (!is_term && c != '.' && c != '@' && c != '^') {
      Refuse("expected an IRI in angles, a blank node, a literal or a point");
    }
    line_has_statement_ = true;
    line_is_ended_ = c == '.';
  }

  void EndLine() {
    if (line_has_statement_ && !line_is_ended_) {
      Refuse("expected a point before the end of the line");
    }
    line_has_statement_ = line_is_ended_ = false;
  }

  [[noreturn]] void Refuse(const std::string& what) const {
    throw InputError(TurtleErrorPlace(text_, source_, at_) + what);
  }

  // serd 0.30 reads TriG's `name { ... }` as Turtle and drops the name.
  [[noreturn]] void RefuseBrace() const {
    Refuse("a brace; expected Turtle, which has no named graphs");
  }

  [[noreturn]] void RefuseNesting() const {
    Refuse("brackets nested deeper than the limit of " +
           std::to_string(max_nesting_));
  }

  const std::string_view text_;
  const std::string& source_;
  const bool has_braces_;
  const bool is_lines_;
  const int max_nesting_;
  std::size_t at_ = 0;
  int nesting_ = 0;
  bool line_has_statement_ = false;
  bool line_is_ended_ = false;
  std::vector<InsertedByte> inserted_;
};

}  // namespace

std::string TurtleErrorPlace(std::string_view text, const std::string& source,
                             std::size_t offset) {
  const kg_base::TextPosition at = kg_base::PositionAt(text, offset);
  return source + ":" + std::to_string(at.line) + ":" +
         std::to_string(at.column) + ": ";
}

std::vector<InsertedByte> CheckRdfText(std::string_view text, RdfSyntax syntax,
                                       const std::string& source,
                                       const TurtleLimits& limits) {
  if (text.size() > limits.bytes) {
    throw InputError(source + ":1:1: text of " + std::to_string(text.size()) +
                     " bytes; expected at most " +
                     std::to_string(limits.bytes));
  }
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw InputError(TurtleErrorPlace(text, source, nul) +
                     "NUL byte; expected text");
  }
  if (const auto bad = kg_base::FirstBadUtf8(text)) {
    throw InputError(TurtleErrorPlace(text, source, *bad) +
                     "byte that is not UTF-8");
  }
  return TurtleScanner(text, syntax, source, limits.nesting).Run();
}

}  // namespace kg_core
