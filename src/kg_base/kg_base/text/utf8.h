// UTF-8 helpers for string functions and the lexer.

#ifndef KG_BASE_TEXT_UTF8_H_
#define KG_BASE_TEXT_UTF8_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kg_base {

// Offset of the first invalid byte, or npos.
std::size_t FindInvalidUtf8(std::string_view text);

// The functions below require valid UTF-8.
std::size_t Utf8Length(std::string_view text);  // In characters.
// The byte at which character `index` begins; the size if there are fewer.
std::size_t Utf8Offset(std::string_view text, std::size_t index);
// Reads the character at byte *at and advances *at past it.
std::uint32_t TakeUtf8(std::string_view text, std::size_t* at);

// Unicode's full default case mapping, independent of the locale: a letter may
// become two ("ß": "SS"), a final sigma is one.
std::string UpperCase(std::string_view text);
std::string LowerCase(std::string_view text);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_UTF8_H_
