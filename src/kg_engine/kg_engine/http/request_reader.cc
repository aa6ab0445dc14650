#include "kg_engine/http/request_reader.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "absl/strings/ascii.h"
#include "kg_base/common/text.h"
#include "kg_engine/protocol/http.h"

namespace kg_engine {
namespace {

// A chunk's size and its extensions.
constexpr std::size_t kChunkLineBytes = 4096;
constexpr std::size_t kBlockBytes = 16384;

// Reads lines and blocks of one request.
class LimitedReader {
 public:
  explicit LimitedReader(const ReadBytes& read) : read_(read) {}

  bool has_begun() const { return has_begun_; }

  // A line without its CRLF. Throws HttpError `too_long` beyond `max_bytes`.
  std::string ReadLine(std::size_t max_bytes, const HttpError& too_long) {
    std::string line;
    for (char c = ReadByte(); c != '\n'; c = ReadByte()) {
      line += c;
      if (line.size() > max_bytes) throw too_long;
    }
    if (line.empty() || line.back() != '\r') {
      throw HttpError(kBadRequest, "expected every line to end with CRLF");
    }
    line.pop_back();
    return line;
  }

  void Append(std::size_t size, std::string* to) {
    char block[kBlockBytes];
    while (size > 0) {
      const std::size_t count = Read(block, std::min(size, sizeof block));
      to->append(block, count);
      size -= count;
    }
  }

 private:
  std::size_t Read(char* bytes, std::size_t size) {
    const std::ptrdiff_t count = read_(bytes, size);
    if (count == 0) {
      throw HttpError(kBadRequest, "the request ends before it is whole");
    }
    if (count < 0) {
      throw HttpError(kRequestTimeout,
                      "the request did not arrive whole in time");
    }
    has_begun_ = true;
    return static_cast<std::size_t>(count);
  }
  char ReadByte() {
    char c = 0;
    Read(&c, 1);
    return c;
  }

  const ReadBytes& read_;
  bool has_begun_ = false;
};

struct HeadLines {
  std::string request_line;
  std::vector<std::string> fields;  // "Name: value"
};

std::string FieldName(const std::string& field) {
  return kg_base::ToLowerAscii(field.substr(0, field.find(':')));
}

std::string FieldValue(const std::string& field) {
  const std::size_t colon = field.find(':');
  if (colon == std::string::npos) return "";
  return std::string(
      kg_base::StripAsciiSpace(std::string_view(field).substr(colon + 1)));
}

std::vector<std::string> FindValues(const HeadLines& head,
                                    const std::string& name) {
  std::vector<std::string> values;
  for (const std::string& field : head.fields) {
    if (FieldName(field) == name) values.push_back(FieldValue(field));
  }
  return values;
}

void RemoveField(const std::string& name, HeadLines* head) {
  head->fields.erase(std::remove_if(head->fields.begin(), head->fields.end(),
                                    [&name](const std::string& field) {
                                      return FieldName(field) == name;
                                    }),
                     head->fields.end());
}

HttpError LongHead(std::size_t limit) {
  return HttpError(kHeadersTooLarge,
                   "the header fields are longer than the limit of " +
                       std::to_string(limit) + " bytes");
}

// Fields until the empty line: of a head, or after the last chunk.
std::vector<std::string> ReadFields(std::size_t limit, std::size_t used,
                                    LimitedReader* reader) {
  std::vector<std::string> fields;
  while (true) {
    std::string field = reader->ReadLine(limit - used, LongHead(limit));
    if (field.empty()) return fields;
    used = std::min(limit, used + field.size() + 2);
    fields.push_back(std::move(field));
  }
}

HeadLines ReadHead(std::size_t limit, LimitedReader* reader) {
  HeadLines head;
  head.request_line = reader->ReadLine(
      limit, HttpError(kUriTooLong,
                       "the request line is longer than the limit"
                       " of " +
                           std::to_string(limit) + " bytes"));
  head.fields = ReadFields(limit, head.request_line.size(), reader);
  return head;
}

// "GET http://host:80/a?b HTTP/1.1" becomes "GET /a?b HTTP/1.1", and the host
// of the target takes the place of the Host field: RFC 9112, 3.2.2.
void ToOriginForm(HeadLines* head) {
  const std::string& line = head->request_line;
  const std::size_t begin = line.find(' ') + 1;
  const std::size_t end = line.find(' ', begin);
  if (begin == 0 || end == std::string::npos) return;
  const std::string target = line.substr(begin, end - begin);
  const std::size_t scheme_end = target.find("://");
  if (target[0] == '/' || scheme_end == std::string::npos) return;
  const std::string scheme =
      kg_base::ToLowerAscii(target.substr(0, scheme_end));
  const std::size_t host_begin = scheme_end + 3;
  const std::size_t host_end =
      std::min(target.find_first_of("/?#", host_begin), target.size());
  const std::string host = target.substr(host_begin, host_end - host_begin);
  if (scheme != "http" || host.empty() || host.find('@') != std::string::npos) {
    throw HttpError(kBadRequest,
                    "expected a target like /sparql or http://HOST/sparql");
  }
  std::string path = target.substr(host_end);
  if (path.empty() || path[0] != '/') path.insert(0, "/");
  head->request_line = line.substr(0, begin) + path + line.substr(end);
  RemoveField("host", head);
  head->fields.push_back("Host: " + host);
}

// RFC 9110, 5.6.2
bool IsTokenChar(char c) {
  return absl::ascii_isalnum(c) ||
         std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

// Each field has a name, right before its colon, and at most one is the Host:
// RFC 9112, 3.2 and 5.1.
void CheckFields(const HeadLines& head) {
  for (const std::string& field : head.fields) {
    const auto colon = std::find(field.begin(), field.end(), ':');
    const bool has_name = colon != field.begin() && colon != field.end() &&
                          std::all_of(field.begin(), colon, IsTokenChar);
    if (!has_name) {
      throw HttpError(kBadRequest, "expected header fields like Name: value");
    }
  }
  if (FindValues(head, "host").size() > 1) {
    throw HttpError(kBadRequest, "expected one Host");
  }
}

// A body that is too long is refused before it is sent.
void CheckContentLength(const HeadLines& head, std::size_t max_bytes) {
  const std::vector<std::string> lengths = FindValues(head, "content-length");
  for (const std::string& length : lengths) {
    if (!length.empty() && length == lengths.front() &&
        length.find_first_not_of("0123456789") == std::string::npos) {
      continue;
    }
    throw HttpError(kBadRequest, "expected one Content-Length, in digits");
  }
  if (lengths.empty()) return;
  constexpr std::size_t kMaxDigits = 18;  // Fit into the type.
  if (lengths[0].size() <= kMaxDigits && std::stoull(lengths[0]) <= max_bytes) {
    return;
  }
  throw HttpError(kContentTooLarge, "the body is longer than the limit of " +
                                        std::to_string(max_bytes) + " bytes");
}

// The size that begins a chunk's line; extensions are ignored. `used` bytes of
// `max_bytes` are in earlier chunks.
std::size_t ParseChunkSize(const std::string& line, std::size_t used,
                           std::size_t max_bytes) {
  const std::string_view digits = kg_base::StripAsciiSpace(
      std::string_view(line).substr(0, line.find(';')));
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  if (digits.empty()) {
    throw HttpError(kBadRequest, "a chunk has no size");
  }
  std::size_t size = 0;
  for (const char c : kg_base::ToLowerAscii(digits)) {
    const std::size_t value = kHexDigits.find(c);
    if (value == std::string_view::npos) {
      throw HttpError(kBadRequest,
                      "the size of a chunk is no hexadecimal number");
    }
    size = 16 * size + value;
    if (size > max_bytes - used) {
      throw HttpError(kContentTooLarge,
                      "the body is longer than the limit of " +
                          std::to_string(max_bytes) + " bytes");
    }
  }
  return size;
}

// The body of all chunks. Trailer fields are read and dropped: RFC 9112, 7.1.2.
std::string ReadChunks(const RequestLimits& limits, LimitedReader* reader) {
  const HttpError long_line(kBadRequest, "the line of a chunk is longer than " +
                                             std::to_string(kChunkLineBytes) +
                                             " bytes");
  std::string body;
  while (true) {
    const std::size_t size =
        ParseChunkSize(reader->ReadLine(kChunkLineBytes, long_line),
                       body.size(), limits.body_bytes);
    if (size == 0) break;
    reader->Append(size, &body);
    if (!reader->ReadLine(kChunkLineBytes, long_line).empty()) {
      throw HttpError(kBadRequest, "a chunk is longer than its size");
    }
  }
  ReadFields(limits.head_bytes, 0, reader);
  return body;
}

// True if the body comes in chunks. Throws HttpError for other codings.
bool IsChunked(const HeadLines& head) {
  const std::vector<std::string> codings =
      FindValues(head, "transfer-encoding");
  if (codings.empty()) return false;
  if (codings.size() > 1 || kg_base::ToLowerAscii(codings[0]) != "chunked") {
    throw HttpError(kNotImplemented,
                    "expected Transfer-Encoding: chunked, or none");
  }
  // A length beside it could make two readers disagree about the end.
  if (!FindValues(head, "content-length").empty()) {
    throw HttpError(kBadRequest,
                    "expected Content-Length or Transfer-Encoding, not both");
  }
  return true;
}

std::string TakeRange(HeadLines* head) {
  const std::vector<std::string> ranges = FindValues(*head, "range");
  RemoveField("range", head);
  return ranges.size() == 1 ? ranges[0] : "";
}

std::string JoinHead(const HeadLines& head) {
  std::string text = head.request_line + "\r\n";
  for (const std::string& field : head.fields) text += field + "\r\n";
  return text + "\r\n";
}

// Replaces a chunked body by one of a known length.
std::string TakeChunks(const RequestLimits& limits,
                       const BeforeBody& before_body, HeadLines* head,
                       LimitedReader* reader) {
  const std::vector<std::string> expected = FindValues(*head, "expect");
  before_body(expected.size() == 1 &&
              kg_base::ToLowerAscii(expected[0]) == "100-continue");
  std::string body = ReadChunks(limits, reader);
  RemoveField("expect", head);
  RemoveField("transfer-encoding", head);
  head->fields.push_back("Content-Length: " + std::to_string(body.size()));
  return body;
}

}  // namespace

RequestText ReadRequest(const RequestLimits& limits, const ReadBytes& read,
                        const BeforeBody& before_body) {
  LimitedReader reader(read);
  HeadLines head;
  try {
    head = ReadHead(limits.head_bytes, &reader);
  } catch (const HttpError&) {
    if (!reader.has_begun()) return {};  // Nobody waits for an answer.
    throw;
  }
  CheckFields(head);
  ToOriginForm(&head);
  CheckContentLength(head, limits.body_bytes);
  RequestText request;
  request.range = TakeRange(&head);
  std::string body;
  if (IsChunked(head)) {
    body = TakeChunks(limits, before_body, &head, &reader);
  } else if (FindValues(head, "content-length").empty()) {
    head.fields.push_back("Content-Length: 0");  // RFC 9112, 6.3.
  }
  request.text = JoinHead(head) + body;
  return request;
}

}  // namespace kg_engine
