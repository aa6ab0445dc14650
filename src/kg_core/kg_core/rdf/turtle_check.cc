#include "kg_core/rdf/turtle_check.h"

#include <algorithm>

#include "kg_core/base/input_error.h"
#include "kg_core/base/text.h"

namespace kg_core {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// Walks over comments, IRIs and strings, and looks at what stands between.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& source, int max_nesting)
      : text_(text), source_(source), max_nesting_(max_nesting) {}

  void Run() {
    while (at_ < text_.size()) Step();
  }

 private:
  void Step() {
    switch (text_[at_]) {
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return;
      case '<':
        at_ = std::min(text_.find_first_of(">\n", at_ + 1), text_.size() - 1);
        break;
      case '"':
      case '\'':
        SkipString();
        return;
      case '\\':  // Escape in a local name: the next character is no syntax.
        ++at_;
        break;
      case '{':
      case '}':
        RefuseBrace();
      case '[':
      case '(':
        if (++nesting_ > max_nesting_) RefuseNesting();
        break;
      case ']':
      case ')':
        if (nesting_ > 0) --nesting_;
        break;
      case '_':
        NoteBlankLabel();
        break;
      default:
        break;
    }
    ++at_;
  }

  void SkipString() {
    const char quote = text_[at_];
    const bool is_long = text_.substr(at_, 3) == std::string(3, quote);
    const std::string end(is_long ? 3 : 1, quote);
    at_ += end.size();
    while (at_ < text_.size() && text_.substr(at_, end.size()) != end) {
      if (!is_long && text_[at_] == '\n') return;
      at_ += text_[at_] == '\\' ? 2 : 1;
    }
    at_ = std::min(at_ + end.size(), text_.size());
  }

  // serd reads _:b1 as "B1" to keep it apart from its own labels, so _:b1 and
  // _:B1 in one text would become one node.
  void NoteBlankLabel() {
    const std::string_view label = text_.substr(at_, 4);
    if (label.size() < 4 || label[1] != ':' || !IsDigit(label[3])) return;
    (label[2] == 'b' ? has_small_b_ : has_large_b_) |=
        label[2] == 'b' || label[2] == 'B';
    if (has_small_b_ && has_large_b_) {
      throw InputError(TurtleErrorPlace(text_, source_, at_) +
                       "blank node labels like _:b1 and _:B1 in one text; "
                       "expected only one of the two spellings");
    }
  }

  // serd 0.30 reads TriG's `name { ... }` as Turtle and drops the name.
  [[noreturn]] void RefuseBrace() const {
    throw InputError(TurtleErrorPlace(text_, source_, at_) +
                     "a brace; expected Turtle, which has no named graphs");
  }

  [[noreturn]] void RefuseNesting() const {
    throw InputError(TurtleErrorPlace(text_, source_, at_) +
                     "brackets nested deeper than the limit of " +
                     std::to_string(max_nesting_));
  }

  const std::string_view text_;
  const std::string& source_;
  const int max_nesting_;
  std::size_t at_ = 0;
  int nesting_ = 0;
  bool has_small_b_ = false;
  bool has_large_b_ = false;
};

}  // namespace

std::string TurtleErrorPlace(std::string_view text, const std::string& source,
                             std::size_t offset) {
  const TextPosition at = PositionAt(text, offset);
  return source + ":" + std::to_string(at.line) + ":" +
         std::to_string(at.column) + ": ";
}

void CheckTurtleText(std::string_view text, const std::string& source,
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
  if (const auto bad = FirstBadUtf8(text)) {
    throw InputError(TurtleErrorPlace(text, source, *bad) +
                     "byte that is not UTF-8");
  }
  Scanner(text, source, limits.nesting).Run();
}

}  // namespace kg_core
