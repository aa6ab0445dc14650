#include "kg_base/text/utf8.h"

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

// Runs of letters with a constant distance to the other case, or alternating.
struct CaseRun {
  std::uint32_t first_upper;
  std::uint32_t last_upper;
  std::uint32_t distance;  // lower - upper; 1: upper, lower, upper, ...
};
constexpr CaseRun kCaseRuns[] = {
    {'A', 'Z', 32},       {0x00C0, 0x00D6, 32}, {0x00D8, 0x00DE, 32},
    {0x0100, 0x012E, 1},  {0x0132, 0x0136, 1},  {0x0139, 0x0147, 1},
    {0x014A, 0x0176, 1},  {0x0179, 0x017D, 1},  {0x0391, 0x03A1, 32},
    {0x03A3, 0x03AB, 32}, {0x0400, 0x040F, 80}, {0x0410, 0x042F, 32},
    {0x0460, 0x0480, 1},  {0x1E00, 0x1E94, 1},
};

bool InRun(const CaseRun& run, std::uint32_t upper) {
  if (upper < run.first_upper || upper > run.last_upper) return false;
  return run.distance != 1 || (upper - run.first_upper) % 2 == 0;
}

std::uint32_t ToUpper(std::uint32_t code) {
  for (const CaseRun& run : kCaseRuns) {
    if (code >= run.distance && InRun(run, code - run.distance)) {
      return code - run.distance;
    }
  }
  return code;
}

std::uint32_t ToLower(std::uint32_t code) {
  for (const CaseRun& run : kCaseRuns) {
    if (InRun(run, code)) return code + run.distance;
  }
  return code;
}

template <typename Map>
std::string MapCharacters(std::string_view text, Map map) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    AppendUtf8(map(TakeUtf8(text, &at)), &out);
  }
  return out;
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
  return MapCharacters(text, ToUpper);
}

std::string LowerCase(std::string_view text) {
  return MapCharacters(text, ToLower);
}

}  // namespace kg_base
