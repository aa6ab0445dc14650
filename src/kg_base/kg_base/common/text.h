// Helpers for bytes that should be text (UTF-8, RFC 3629).

#ifndef KG_BASE_COMMON_TEXT_H_
#define KG_BASE_COMMON_TEXT_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kg_base {

// Byte offset of the first byte that is not well-formed UTF-8 (overlong forms,
// surrogates and code points above U+10FFFF are ill-formed); nullopt if none.
std::optional<std::size_t> FirstBadUtf8(std::string_view bytes);

// Appends a code point; the caller has checked IsUnicodeScalar.
void AppendUtf8(std::uint32_t code_point, std::string* text);
bool IsUnicodeScalar(std::uint32_t code_point);

// The first characters of well-formed `text` that take at most `max_bytes` in
// all, for messages about long texts.
std::string_view FirstCharacters(std::string_view text, std::size_t max_bytes);

std::string ToLowerAscii(std::string_view text);
std::string_view StripAsciiSpace(std::string_view text);

// A line and a column, both from 1; columns count bytes.
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
};
TextPosition PositionAt(std::string_view text, std::size_t offset);

// Whole contents; throws InputError that names the file if it cannot be read
// or is longer than `max_bytes`.
std::string ReadFile(const std::string& path, std::size_t max_bytes);

}  // namespace kg_base

#endif  // KG_BASE_COMMON_TEXT_H_
