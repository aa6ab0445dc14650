// The few things of UTF-8 that string functions and the lexer need.

#ifndef KG_BASE_TEXT_UTF8_H_
#define KG_BASE_TEXT_UTF8_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kg_base {

// Is it a Unicode scalar value (no surrogate, not above U+10FFFF)?
// Where `text` stops being UTF-8, or npos.
std::size_t FindInvalidUtf8(std::string_view text);

// Below, `text` is UTF-8.
std::size_t Utf8Length(std::string_view text);  // In characters.
// The byte at which character `index` begins; the size if there are fewer.
std::size_t Utf8Offset(std::string_view text, std::size_t index);
// The character at byte *at, which moves behind it.
std::uint32_t TakeUtf8(std::string_view text, std::size_t* at);

// Simple case mapping, character by character (towupper of a UTF-8 locale is
// not relied upon: Latin, Greek and Cyrillic are mapped, the rest is kept).
std::string UpperCase(std::string_view text);
std::string LowerCase(std::string_view text);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_UTF8_H_
