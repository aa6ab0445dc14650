#include "kg_engine/http/request_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "kg_engine/protocol/http.h"

namespace kg_engine {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// A client that sends `text` in blocks, then nothing more (-1) or the end (0).
class Sender {
 public:
  Sender(std::string text, std::size_t block, std::ptrdiff_t at_end)
      : text_(std::move(text)), block_(block), at_end_(at_end) {}

  RequestText Read() {
    return ReadRequest(
        {1000, 5000},
        [this](char* bytes, std::size_t size) -> std::ptrdiff_t {
          const std::size_t count = text_.copy(
              bytes, std::min({size, block_, text_.size() - begin_}), begin_);
          begin_ += count;
          return count > 0 ? static_cast<std::ptrdiff_t>(count) : at_end_;
        },
        [this](bool is_awaited) { continues_ += is_awaited ? 1 : 0; });
  }
  std::size_t begin() const { return begin_; }
  int continues() const { return continues_; }

 private:
  const std::string text_;
  const std::size_t block_;
  const std::ptrdiff_t at_end_;
  std::size_t begin_ = 0;
  int continues_ = 0;
};

RequestText Read(const std::string& text) {
  return Sender(text, 1 << 20, -1).Read();
}

int StatusOf(const std::string& text, std::ptrdiff_t at_end = -1) {
  try {
    Sender(text, 1 << 20, at_end).Read();
    return 0;
  } catch (const HttpError& error) {
    return error.status();
  }
}

std::string Chunked(const std::string& body) {
  return "POST /x HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n\r\n" +
         body;
}

TEST(RequestReaderTest, KeepsWhatNeedsNoChange) {
  const std::string head =
      "POST /a?b=%2B HTTP/1.1\r\nHost: h\r\nContent-Length: 3\r\n\r\n";
  for (const std::size_t block : {1u, 7u, 4096u}) {
    Sender sender(head + "abc", block, -1);
    EXPECT_EQ(sender.Read().text, head);
    EXPECT_EQ(sender.begin(), head.size());  // The body is left.
  }
  // A request without a length has no body.
  EXPECT_EQ(Read("PUT / HTTP/1.1\r\n\r\n").text,
            "PUT / HTTP/1.1\r\nContent-Length: 0\r\n\r\n");
}

TEST(RequestReaderTest, JoinsChunks) {
  for (const char* body :
       {"5\r\nhello\r\n0\r\n\r\n", "2\r\nhe\r\n3\r\nllo\r\n0\r\n\r\n",
        "5;a=b;c=\"d e\"\r\nhello\r\n0;last\r\n\r\n",
        "0005 \r\nhello\r\n000\r\n\r\n",
        "5\r\nhello\r\n0\r\nX-Sum: 1\r\nX-Other: 2\r\n\r\n"}) {
    const std::string text = Read(Chunked(body)).text;
    EXPECT_THAT(text, EndsWith("\r\nContent-Length: 5\r\n\r\nhello")) << body;
    EXPECT_THAT(text, Not(HasSubstr("chunked"))) << body;
  }
  const std::string bytes = "\r\n0\r\n\r\n;";
  EXPECT_THAT(Read(Chunked("A\r\n" + bytes + "xx\r\n0\r\n\r\n")).text,
              EndsWith("\r\n\r\n" + bytes + "xx"));
}

TEST(RequestReaderTest, SaysAtOnceThatAChunkIsMalformed) {
  for (const char* body :
       {"zz\r\n", "\r\n", ";a\r\n", "-1\r\n", "0x5\r\n", "5 5\r\n", "+5\r\n",
        "5\n", "5\r\nhello!\r\n", "5\r\nhello\r\ng\r\n"}) {
    EXPECT_EQ(StatusOf(Chunked(body)), kBadRequest) << body;
  }
}

TEST(RequestReaderTest, ReadsNoMoreThanTheLimits) {
  const std::string endless(100000, 'a');
  const struct {
    std::string text;
    int status;
  } kCases[] = {
      {"GET /" + endless, kUriTooLong},
      {"GET / HTTP/1.1\r\nA: " + endless, kHeadersTooLarge},
      {Chunked("5;" + endless), kBadRequest},
      {Chunked(endless), kBadRequest},
      {Chunked("1389\r\n" + endless), kContentTooLarge},
      {Chunked("fffffffffffffffffffffffff\r\n"), kContentTooLarge},
      {Chunked("0\r\nA: " + endless), kHeadersTooLarge},
  };
  for (const auto& one : kCases) {
    Sender sender(one.text, 1 << 20, -1);
    EXPECT_THROW(sender.Read(), HttpError);
    EXPECT_LT(sender.begin(), 6000u) << one.text.substr(0, 80);
    EXPECT_EQ(StatusOf(one.text), one.status) << one.text.substr(0, 80);
  }
  std::string many = "GET / HTTP/1.1\r\n";
  for (int i = 0; i < 1000; ++i) many += "A: b\r\n";
  EXPECT_EQ(StatusOf(many + "\r\n"), kHeadersTooLarge);
  std::string chunks;
  for (int i = 0; i < 6; ++i) {
    chunks += "3e8\r\n" + std::string(1000, 'x') + "\r\n";
  }
  EXPECT_EQ(StatusOf(Chunked(chunks)), kContentTooLarge);
}

TEST(RequestReaderTest, RefusesTwoLengthsAndOtherCodings) {
  const std::string post = "POST / HTTP/1.1\r\n";
  for (const char* fields :
       {"Content-Length: 3\r\nTransfer-Encoding: chunked\r\n",
        "Content-Length: 3\r\nContent-Length: 4\r\n", "Content-Length: -3\r\n",
        "Content-Length: 3a\r\n", "Content-Length:\r\n"}) {
    EXPECT_EQ(StatusOf(post + fields + "\r\n"), kBadRequest) << fields;
  }
  for (const char* coding : {"gzip", "gzip, chunked", "chunked, chunked"}) {
    EXPECT_EQ(StatusOf(post + "Transfer-Encoding: " + coding + "\r\n\r\n"),
              kNotImplemented)
        << coding;
  }
}

TEST(RequestReaderTest, RefusesABodyThatIsTooLongBeforeItIsSent) {
  for (const char* length :
       {"100000000", "99999999999999999999", "18446744073709551617"}) {
    EXPECT_EQ(StatusOf(std::string("POST / HTTP/1.1\r\nContent-Length: ") +
                       length + "\r\n\r\n"),
              kContentTooLarge)
        << length;
  }
}

TEST(RequestReaderTest, RefusesFieldsThatAreNone) {
  for (const char* field : {"X : a", ": a", "X", " X: a", "X: a\r\n b", "X(: a",
                            "Host: a\r\nhost: a"}) {
    EXPECT_EQ(StatusOf(std::string("GET / HTTP/1.1\r\n") + field + "\r\n\r\n"),
              kBadRequest)
        << field;
  }
}

TEST(RequestReaderTest, TakesTargetsInAbsoluteForm) {
  const struct {
    const char* target;
    const char* origin;
  } kCases[] = {
      {"http://other:80/a/b?c=d", "/a/b?c=d"},
      {"HTTP://other:80", "/"},
      {"http://other:80?c=http://x/y", "/?c=http://x/y"},
      {"http://other:80/a://b", "/a://b"},
  };
  for (const auto& one : kCases) {
    const std::string text = Read("GET " + std::string(one.target) +
                                  " HTTP/1.1\r\nHost: this\r\n\r\n")
                                 .text;
    EXPECT_THAT(text,
                StartsWith("GET " + std::string(one.origin) + " HTTP/1.1\r\n"));
    EXPECT_THAT(text, HasSubstr("\r\nHost: other:80\r\n"));
    EXPECT_THAT(text, Not(HasSubstr("this")));
  }
  EXPECT_THAT(Read("GET /a?b=http://c HTTP/1.1\r\n\r\n").text,
              StartsWith("GET /a?b=http://c HTTP/1.1\r\n"));
  for (const char* target : {"ftp://h/a", "http:///a", "http://u:p@h/a"}) {
    EXPECT_EQ(StatusOf("GET " + std::string(target) + " HTTP/1.1\r\n\r\n"),
              kBadRequest)
        << target;
  }
}

TEST(RequestReaderTest, TakesRangesOut) {
  const RequestText one =
      Read("GET / HTTP/1.1\r\nrange:  bytes=1-2 \r\nA: b\r\n\r\n");
  EXPECT_EQ(one.range, "bytes=1-2");
  EXPECT_EQ(one.text, "GET / HTTP/1.1\r\nA: b\r\nContent-Length: 0\r\n\r\n");
  const RequestText two =
      Read("GET / HTTP/1.1\r\nRange: bytes=1-2\r\nRANGE: bytes=1-2\r\n\r\n");
  EXPECT_EQ(two.range, "");
  EXPECT_EQ(two.text, "GET / HTTP/1.1\r\nContent-Length: 0\r\n\r\n");
}

TEST(RequestReaderTest, TellsAClientThatWaitsToContinue) {
  Sender sender(
      "POST / HTTP/1.1\r\nExpect: 100-Continue\r\n"
      "Transfer-Encoding: chunked\r\n\r\n1\r\na\r\n0\r\n\r\n",
      1 << 20, -1);
  EXPECT_THAT(sender.Read().text, Not(HasSubstr("Expect")));
  EXPECT_EQ(sender.continues(), 1);
}

TEST(RequestReaderTest, TellsWhatIsLateFromWhatHasEnded) {
  for (const std::string& text :
       {std::string("GET / HT"), std::string("GET / HTTP/1.1\r\nA: b\r\n"),
        Chunked("5\r\nhel"), Chunked("5\r\nhello\r\n0\r\n")}) {
    EXPECT_EQ(StatusOf(text, -1), kRequestTimeout) << text;
    EXPECT_EQ(StatusOf(text, 0), kBadRequest) << text;
  }
  // Idle clients get no answer.
  EXPECT_EQ(Sender("", 1, -1).Read().text, "");
  EXPECT_EQ(Sender("", 1, 0).Read().text, "");
}

}  // namespace
}  // namespace kg_engine
