#include "kg_engine/protocol/byte_range.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "kg_base/common/text.h"

namespace kg_engine {
namespace {

// Positions of the first byte and of the one after the last.
struct ByteSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// nullopt unless the text is digits only; too large numbers are saturated.
std::optional<std::size_t> ParsePosition(std::string_view text) {
  constexpr std::size_t kMax = std::numeric_limits<std::size_t>::max() / 16;
  if (text.empty()) return std::nullopt;
  std::size_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = std::min(kMax, 10 * value + static_cast<std::size_t>(c - '0'));
  }
  return value;
}

// "bytes=2-5", "bytes=2-", "bytes=-4" of so many bytes; an empty span if none
// of them is asked for. nullopt: not one range of bytes.
std::optional<ByteSpan> ParseRange(std::string_view header, std::size_t size) {
  constexpr std::string_view kUnit = "bytes=";
  if (kg_base::ToLowerAscii(std::string(header.substr(0, kUnit.size()))) !=
      kUnit) {
    return std::nullopt;
  }
  const std::string_view range = header.substr(kUnit.size());
  const std::size_t dash = range.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const std::string_view first = range.substr(0, dash);
  const std::string_view last = range.substr(dash + 1);
  const auto begin = ParsePosition(first);
  const auto end = ParsePosition(last);
  if (first.empty() && end) return ByteSpan{size - std::min(size, *end), size};
  if (!begin || (!end && !last.empty())) return std::nullopt;
  if (end && *end < *begin) return std::nullopt;
  return ByteSpan{std::min(size, *begin),
                  end ? std::min(size, *end + 1) : size};
}

}  // namespace

void ApplyRange(const HttpRequest& request, HttpResponse* response) {
  const std::string header = Header(request, "range");
  if (header.empty() || request.method != "GET" || response->status != kOk ||
      response->body.empty() || !Header(request, "if-range").empty()) {
    return;
  }
  const std::size_t size = response->body.size();
  const auto span = ParseRange(header, size);
  if (!span) return;
  if (span->begin == span->end) {
    response->status = kRangeNotSatisfiable;
    response->headers["Content-Range"] = "bytes */" + std::to_string(size);
    response->content_type = kPlainText;
    response->body = "the answer has only " + std::to_string(size) +
                     " bytes, none in the range '" + header + "'\n";
    return;
  }
  response->status = kPartialContent;
  response->headers["Content-Range"] = "bytes " + std::to_string(span->begin) +
                                       "-" + std::to_string(span->end - 1) +
                                       "/" + std::to_string(size);
  response->body = response->body.substr(span->begin, span->end - span->begin);
}

}  // namespace kg_engine
