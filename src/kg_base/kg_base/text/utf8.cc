#include "kg_base/text/utf8.h"

#include <unicode/bytestream.h>
#include <unicode/casemap.h>
#include <unicode/utypes.h>

#include <stdexcept>

#include "kg_base/common/text.h"

namespace kg_base {
namespace {

bool IsContinuation(char c) { return (c & 0xC0) == 0x80; }

// Length of the character with this lead byte; 0 if it is not a lead byte.
std::size_t GetLength(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  if (byte < 0x80) return 1;
  if (byte >= 0xC2 && byte <= 0xDF) return 2;
  if (byte >= 0xE0 && byte <= 0xEF) return 3;
  if (byte >= 0xF0 && byte <= 0xF4) return 4;
  return 0;
}

// ICU counts bytes in 32 bits.
std::int32_t CheckedLength(std::string_view text) {
  if (text.size() > static_cast<std::size_t>(INT32_MAX)) {
    throw std::length_error("text of more than 2 GiB");
  }
  return static_cast<std::int32_t>(text.size());
}

using CaseMapping = void (*)(const char* locale, std::uint32_t options,
                             icu::StringPiece text, icu::ByteSink& mapped,
                             icu::Edits* edits, UErrorCode& status);

// Full case mapping that depends on no language.
std::string MapCase(std::string_view text, CaseMapping map) {
  std::string mapped;
  icu::StringByteSink<std::string> sink(&mapped);
  UErrorCode status = U_ZERO_ERROR;
  map("", 0, {text.data(), CheckedLength(text)}, sink, nullptr, status);
  if (U_FAILURE(status) != 0) throw std::runtime_error(u_errorName(status));
  return mapped;
}

}  // namespace

std::size_t FindInvalidUtf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = GetLength(text[at]);
    if (length == 0 || at + length > text.size()) return at;
    for (std::size_t i = 1; i < length; ++i) {
      if (!IsContinuation(text[at + i])) return at;
    }
    std::size_t next = at;
    const std::uint32_t code = TakeUtf8(text, &next);
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < kLeast[length] || !IsUnicodeScalar(code)) return at;
    at = next;
  }
  return std::string_view::npos;
}

std::size_t Utf8Length(std::string_view text) {
  std::size_t length = 0;
  for (const char c : text) length += IsContinuation(c) ? 0 : 1;
  return length;
}

std::size_t Utf8Offset(std::string_view text, std::size_t index) {
  std::size_t seen = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (IsContinuation(text[at])) continue;
    if (seen++ == index) return at;
  }
  return text.size();
}

std::uint32_t TakeUtf8(std::string_view text, std::size_t* at) {
  const char lead = text[*at];
  std::size_t length = GetLength(lead);
  if (length == 0 || *at + length > text.size()) length = 1;
  constexpr std::uint32_t kLeadMask[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  std::uint32_t code = static_cast<unsigned char>(lead) & kLeadMask[length];
  for (std::size_t i = 1; i < length; ++i) {
    code = (code << 6) | (static_cast<unsigned char>(text[*at + i]) & 0x3F);
  }
  *at += length;
  return code;
}

std::string UpperCase(std::string_view text) {
  return MapCase(text, icu::CaseMap::utf8ToUpper);
}

std::string LowerCase(std::string_view text) {
  return MapCase(text, icu::CaseMap::utf8ToLower);
}

}  // namespace kg_base
