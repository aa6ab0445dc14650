#include "kg_base/common/text.h"

#include <algorithm>
#include <fstream>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

// Well-formed byte sequences, Unicode 15 table 3-7: ranges of the first and the
// second byte, and the number of bytes.
struct Utf8Form {
  unsigned char first_low, first_high, second_low, second_high;
  int length;
};
constexpr Utf8Form kForms[] = {
    {0x00, 0x7F, 0x00, 0x00, 1}, {0xC2, 0xDF, 0x80, 0xBF, 2},
    {0xE0, 0xE0, 0xA0, 0xBF, 3}, {0xE1, 0xEC, 0x80, 0xBF, 3},
    {0xED, 0xED, 0x80, 0x9F, 3}, {0xEE, 0xEF, 0x80, 0xBF, 3},
    {0xF0, 0xF0, 0x90, 0xBF, 4}, {0xF1, 0xF3, 0x80, 0xBF, 4},
    {0xF4, 0xF4, 0x80, 0x8F, 4},
};

bool FitsForm(const Utf8Form& form, std::string_view rest) {
  if (rest.size() < static_cast<std::size_t>(form.length)) return false;
  for (int i = 1; i < form.length; ++i) {
    const auto byte = static_cast<unsigned char>(rest[i]);
    const unsigned char low = i == 1 ? form.second_low : 0x80;
    const unsigned char high = i == 1 ? form.second_high : 0xBF;
    if (byte < low || byte > high) return false;
  }
  return true;
}

// Bytes of the character that `rest` starts with; 0 if it is ill-formed.
int Utf8Length(std::string_view rest) {
  const auto first = static_cast<unsigned char>(rest[0]);
  for (const Utf8Form& form : kForms) {
    if (first < form.first_low || first > form.first_high) continue;
    return FitsForm(form, rest) ? form.length : 0;
  }
  return 0;
}

bool IsAsciiSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::optional<std::size_t> FirstBadUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const int length = Utf8Length(bytes.substr(i));
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

bool IsUnicodeScalar(std::uint32_t code_point) {
  return code_point <= 0x10FFFF && (code_point < 0xD800 || code_point > 0xDFFF);
}

void AppendUtf8(std::uint32_t code_point, std::string* text) {
  const auto tail = [&](int shift) {
    text->push_back(static_cast<char>(0x80 | ((code_point >> shift) & 0x3F)));
  };
  // The leading byte holds the top bits and the number of continuation bytes,
  // which hold six bits each.
  if (code_point < 0x80) {
    text->push_back(static_cast<char>(code_point));
  } else if (code_point < 0x800) {
    text->push_back(static_cast<char>(0xC0 | (code_point >> 6)));
    tail(0);
  } else if (code_point < 0x10000) {
    text->push_back(static_cast<char>(0xE0 | (code_point >> 12)));
    tail(6);
    tail(0);
  } else {
    text->push_back(static_cast<char>(0xF0 | (code_point >> 18)));
    tail(12);
    tail(6);
    tail(0);
  }
}

std::string_view FirstCharacters(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return text;
  std::size_t end = max_bytes;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;
  return text.substr(0, end);
}

std::string ToLowerAscii(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string_view StripAsciiSpace(std::string_view text) {
  while (!text.empty() && IsAsciiSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && IsAsciiSpace(text.back())) text.remove_suffix(1);
  return text;
}

TextPosition PositionAt(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t newlines = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 == 0.
  return {newlines + 1, before.size() - line_start + 1};
}

std::string ReadFile(const std::string& path, std::size_t max_bytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened for reading");
  std::string bytes;
  char block[1 << 16];
  while (file.read(block, sizeof(block)), file.gcount() > 0) {
    bytes.append(block, file.gcount());
    if (bytes.size() > max_bytes) {
      throw InputError(path + ": longer than the limit of " +
                       std::to_string(max_bytes) + " bytes");
    }
  }
  if (file.bad() || !file.eof()) throw InputError(path + ": cannot be read");
  return bytes;
}

}  // namespace kg_base
