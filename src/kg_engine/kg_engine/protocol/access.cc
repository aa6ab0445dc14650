#include "kg_engine/protocol/access.h"

#include <sys/stat.h>

#include <algorithm>
#include <string_view>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/text.h"

namespace kg_engine {
namespace {

using kg_base::InputError;
using kg_base::StripAsciiSpace;

constexpr std::size_t kMinTokenBytes = 16;
constexpr std::size_t kMaxTokenBytes = 512;
constexpr std::size_t kMaxAuthorBytes = 200;

bool IsVisible(char c) { return c > ' ' && c <= '~'; }

// Constant-time comparison of two texts of equal length.
bool EqualInConstantTime(std::string_view a, std::string_view b) {
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = static_cast<unsigned char>(difference | (a[i] ^ b[i]));
  }
  return difference == 0;
}

}  // namespace

bool CarriesToken(const HttpRequest& request, const std::string& token) {
  constexpr std::string_view kScheme = "bearer ";
  const std::string header = Header(request, "authorization");
  if (kg_base::ToLowerAscii(header.substr(0, kScheme.size())) != kScheme) {
    return false;
  }
  const std::string_view given =
      StripAsciiSpace(std::string_view(header).substr(kScheme.size()));
  // Compare digests: they have equal length for any input.
  return EqualInConstantTime(kg_base::Sha256Hex(given),
                             kg_base::Sha256Hex(token));
}

bool IsLoopbackHost(const HttpRequest& request) {
  std::string host = kg_base::ToLowerAscii(Header(request, "host"));
  const std::size_t colon = host.rfind(':');
  if (colon != std::string::npos &&
      host.find(']', colon) == std::string::npos) {
    host.resize(colon);
  }
  // HTTP/1.0 requests may lack Host; browsers do not send them.
  return host.empty() || host == "localhost" || host == "127.0.0.1" ||
         host == "[::1]";
}

std::string ReadTokenFile(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    throw InputError(path + ": cannot be opened for reading");
  }
  if (!S_ISREG(status.st_mode)) {
    throw InputError(path + ": expected a file that holds the token");
  }
  // A token that other users can read or write protects nothing.
  if ((status.st_mode & (S_IROTH | S_IWOTH)) != 0) {
    throw InputError(path +
                     ": the token can be read or written by everybody; "
                     "expected chmod 600");
  }
  const std::string text = kg_base::ReadFile(path, 2 * kMaxTokenBytes);
  const std::string token(StripAsciiSpace(text));
  const bool fits = token.size() >= kMinTokenBytes &&
                    token.size() <= kMaxTokenBytes &&
                    std::all_of(token.begin(), token.end(), IsVisible);
  if (fits) return token;
  throw InputError(
      path + ": expected one line of " + std::to_string(kMinTokenBytes) +
      " to " + std::to_string(kMaxTokenBytes) + " visible ASCII characters");
}

std::string GetAuthor(const HttpRequest& request) {
  const std::string header = Header(request, "from");
  const std::string_view from = StripAsciiSpace(header);
  const auto is_text = [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F;
  };
  const bool fits = !from.empty() && from.size() <= kMaxAuthorBytes &&
                    !kg_base::FirstBadUtf8(from) &&
                    std::all_of(from.begin(), from.end(), is_text);
  return fits ? std::string(from) : "http";
}

}  // namespace kg_engine
