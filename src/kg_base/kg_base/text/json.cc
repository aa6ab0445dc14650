#include "kg_base/text/json.h"

#include <algorithm>
#include <cstdint>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_base {
namespace {

constexpr int kMaxNesting = 100;

class JsonParser {
 public:
  explicit JsonParser(std::string_view text) : text_(text) {}

  JsonValue Run() {
    const auto bad = FirstBadUtf8(text_);
    if (bad) {
      at_ = *bad;
      Expected("UTF-8");
    }
    JsonValue value = ReadValue(0);
    SkipBlanks();
    if (at_ < text_.size()) Expected("the end");
    return value;
  }

 private:
  [[noreturn]] void Expected(const std::string& what) const {
    const TextPosition place = PositionAt(text_, at_);
    throw InputError("JSON, " + std::to_string(place.line) + ":" +
                     std::to_string(place.column) + ": expected " + what);
  }
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void SkipBlanks() {
    while (at_ < text_.size() && (Peek() == ' ' || Peek() == '\t' ||
                                  Peek() == '\n' || Peek() == '\r')) {
      ++at_;
    }
  }
  bool Take(std::string_view mark) {
    SkipBlanks();
    if (text_.substr(at_, mark.size()) != mark) return false;
    at_ += mark.size();
    return true;
  }
  void Expect(const char* mark) {
    if (!Take(mark)) Expected("'" + std::string(mark) + "'");
  }

  JsonValue ReadValue(int depth);
  JsonValue ReadArray(int depth);
  JsonValue ReadObject(int depth);
  JsonValue ReadNumber();
  std::string ReadString();
  void ReadEscape(std::string* out);
  std::uint32_t ReadHex4();

  std::string_view text_;
  std::size_t at_ = 0;
};

JsonValue JsonParser::ReadValue(int depth) {
  if (depth > kMaxNesting) Expected("no deeper nesting");
  SkipBlanks();
  JsonValue value;
  if (Peek() == '{') return ReadObject(depth);
  if (Peek() == '[') return ReadArray(depth);
  if (Peek() == '"') {
    value.kind = JsonValue::Kind::kString;
    value.text = ReadString();
  } else if (Take("true")) {
    value.kind = JsonValue::Kind::kBoolean;
    value.boolean = true;
  } else if (Take("false")) {
    value.kind = JsonValue::Kind::kBoolean;
  } else if (!Take("null")) {
    return ReadNumber();
  }
  return value;
}

JsonValue JsonParser::ReadArray(int depth) {
  JsonValue value;
  value.kind = JsonValue::Kind::kArray;
  Expect("[");
  if (Take("]")) return value;
  do {
    value.items.push_back(ReadValue(depth + 1));
  } while (Take(","));
  Expect("]");
  return value;
}

JsonValue JsonParser::ReadObject(int depth) {
  JsonValue value;
  value.kind = JsonValue::Kind::kObject;
  Expect("{");
  if (Take("}")) return value;
  do {
    SkipBlanks();
    if (Peek() != '"') Expected("the name of a member");
    std::string name = ReadString();
    Expect(":");
    value.members.emplace_back(std::move(name), ReadValue(depth + 1));
  } while (Take(","));
  Expect("}");
  return value;
}

JsonValue JsonParser::ReadNumber() {
  JsonValue value;
  value.kind = JsonValue::Kind::kNumber;
  const std::size_t end =
      std::min(text_.find_first_not_of("+-.0123456789eE", at_), text_.size());
  if (end == at_) Expected("a value");
  value.text = std::string(text_.substr(at_, end - at_));
  at_ = end;
  return value;
}

std::string JsonParser::ReadString() {
  std::string out;
  ++at_;
  while (Peek() != '"') {
    if (at_ >= text_.size()) Expected("the end of the string");
    if (static_cast<unsigned char>(Peek()) < 0x20) {
      Expected("an escape instead of a control character");
    }
    if (Peek() == '\\') {
      ReadEscape(&out);
    } else {
      out.push_back(text_[at_++]);
    }
  }
  ++at_;
  return out;
}

void JsonParser::ReadEscape(std::string* out) {
  constexpr std::string_view kFrom = "\"\\/bfnrt";
  constexpr std::string_view kTo = "\"\\/\b\f\n\r\t";
  ++at_;
  if (Peek() == 'u') {
    ++at_;
    std::uint32_t code = ReadHex4();
    // A high surrogate must be followed by its low surrogate.
    if (code >= 0xD800 && code < 0xDC00 && text_.substr(at_, 2) == "\\u") {
      at_ += 2;
      const std::uint32_t low = ReadHex4();
      code = low >= 0xDC00 && low < 0xE000
                 ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00)
                 : code;
    }
    if (!IsUnicodeScalar(code)) Expected("the code of a character");
    AppendUtf8(code, out);
    return;
  }
  const std::size_t i = kFrom.find(Peek());
  if (i == std::string_view::npos || at_ >= text_.size()) {
    Expected("an escape such as \\n");
  }
  ++at_;
  out->push_back(kTo[i]);
}

std::uint32_t JsonParser::ReadHex4() {
  std::uint32_t code = 0;
  for (int i = 0; i < 4; ++i) {
    constexpr std::string_view kDigits = "0123456789abcdef0123456789ABCDEF";
    const std::size_t digit = kDigits.find(Peek());
    if (digit == std::string_view::npos || at_ >= text_.size()) {
      Expected("a hexadecimal digit");
    }
    code = code * 16 + static_cast<std::uint32_t>(digit % 16);
    ++at_;
  }
  return code;
}

}  // namespace

const JsonValue* JsonValue::Find(std::string_view name) const {
  for (const auto& [key, value] : members) {
    if (key == name) return &value;
  }
  return nullptr;
}

JsonValue ParseJson(std::string_view text) { return JsonParser(text).Run(); }

}  // namespace kg_base
