#include "kg_engine/protocol/http.h"

#include <algorithm>
#include <cstdlib>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/text.h"

namespace kg_engine {
namespace {

using kg_base::StripAsciiSpace;
using kg_base::ToLowerAscii;

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string Decode(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out.push_back(text[i] == '+' ? ' ' : text[i]);
      continue;
    }
    // Percent-encoded octet: '%' and two hexadecimal digits.
    const int high = i + 2 < text.size() ? HexDigit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? HexDigit(text[i + 2]) : -1;
    if (high < 0 || low < 0) {
      throw HttpError(kBadRequest,
                      "expected two hexadecimal digits after each '%'");
    }
    out.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  if (kg_base::FirstBadUtf8(out)) {
    throw HttpError(kBadRequest, "expected parameters in UTF-8");
  }
  return out;
}

// One element of an Accept header.
struct MediaRange {
  std::string type;  // "*" matches any.
  std::string subtype;
  double quality = 1.0;
};

// A quality that is not a number in [0, 1] counts as 0.
double Quality(std::string_view text) {
  const std::string number(text);
  char* end = nullptr;
  const double quality = std::strtod(number.c_str(), &end);
  const bool fits =
      !number.empty() && *end == '\0' && quality >= 0.0 && quality <= 1.0;
  return fits ? quality : 0.0;
}

MediaRange ParseRange(std::string_view text) {
  const auto parts = Split(text, ';');
  const std::string name = ToLowerAscii(StripAsciiSpace(parts[0]));
  const std::size_t slash = name.find('/');
  MediaRange range{name.substr(0, slash), "", 1.0};
  if (slash != std::string::npos) range.subtype = name.substr(slash + 1);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::string parameter = ToLowerAscii(StripAsciiSpace(parts[i]));
    if (parameter.compare(0, 2, "q=") == 0) {
      range.quality = Quality(std::string_view(parameter).substr(2));
    }
  }
  return range;
}

// 0 = no match; larger = more specific.
int Specificity(const MediaRange& range, const std::string& offer) {
  const std::size_t slash = offer.find('/');
  if (range.type == "*" && range.subtype == "*") return 1;
  if (range.type != offer.substr(0, slash)) return 0;
  if (range.subtype == "*") return 2;
  return range.subtype == offer.substr(slash + 1) ? 3 : 0;
}

double GetQuality(const std::string& offer,
                  const std::vector<MediaRange>& ranges) {
  int best = 0;
  double quality = 0.0;
  for (const MediaRange& range : ranges) {
    const int specificity = Specificity(range, offer);
    if (specificity <= best) continue;
    best = specificity;
    quality = range.quality;
  }
  return quality;
}

}  // namespace

std::string Header(const HttpRequest& request, const std::string& name) {
  const auto found = request.headers.find(name);
  return found == request.headers.end() ? "" : found->second;
}

std::vector<FormField> ParseForm(std::string_view text) {
  std::vector<FormField> fields;
  for (const std::string_view part : Split(text, '&')) {
    if (part.empty()) continue;
    const std::size_t equals = std::min(part.find('='), part.size());
    FormField field;
    field.name = Decode(part.substr(0, equals));
    if (equals < part.size()) field.value = Decode(part.substr(equals + 1));
    fields.push_back(std::move(field));
  }
  return fields;
}

std::string MediaTypeOfBody(const HttpRequest& request) {
  const std::string coding = ToLowerAscii(Header(request, "content-encoding"));
  if (!coding.empty() && coding != "identity") {
    throw HttpError(kUnsupportedMediaType,
                    "content coding '" + coding + "' is not available");
  }
  const std::string content_type = Header(request, "content-type");
  const auto parts = Split(content_type, ';');
  for (std::size_t i = 1; i < parts.size(); ++i) {
    std::string parameter = ToLowerAscii(StripAsciiSpace(parts[i]));
    parameter.erase(std::remove(parameter.begin(), parameter.end(), '"'),
                    parameter.end());
    // us-ascii is a subset of UTF-8; other parameters are ignored.
    const bool is_charset = parameter.compare(0, 8, "charset=") == 0;
    if (is_charset && parameter != "charset=utf-8" &&
        parameter != "charset=us-ascii") {
      throw HttpError(kUnsupportedMediaType,
                      "expected charset=utf-8, not " + parameter);
    }
  }
  return ToLowerAscii(StripAsciiSpace(parts[0]));
}

std::size_t Negotiate(const std::string& accept,
                      const std::vector<std::string>& offers) {
  if (StripAsciiSpace(accept).empty()) return 0;
  std::vector<MediaRange> ranges;
  for (const std::string_view part : Split(accept, ',')) {
    if (!StripAsciiSpace(part).empty()) ranges.push_back(ParseRange(part));
  }
  std::size_t best = 0;
  double quality = 0.0;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const double offered = GetQuality(offers[i], ranges);
    if (offered <= quality) continue;
    best = i;
    quality = offered;
  }
  if (quality > 0.0) return best;
  throw HttpError(kNotAcceptable, "none of '" + accept +
                                      "' is available here; there are " +
                                      kg_base::JoinStrings(offers));
}

}  // namespace kg_engine
