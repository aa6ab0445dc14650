#include "kg_engine/protocol/byte_range.h"

#include <gtest/gtest.h>

#include <string>

namespace kg_engine {
namespace {

HttpResponse Apply(const std::string& range, const std::string& method = "GET",
                   int status = kOk) {
  HttpRequest request;
  request.method = method;
  request.headers["range"] = range;
  HttpResponse response;
  response.status = status;
  response.content_type = kPlainText;
  response.body = "0123456789";
  ApplyRange(request, &response);
  return response;
}

TEST(ByteRangeTest, SendsTheOnePartThatAGetAsksFor) {
  const struct {
    const char* range;
    const char* body;
    const char* content_range;
  } kCases[] = {
      {"bytes=0-3", "0123", "bytes 0-3/10"},
      {"bytes=9-9", "9", "bytes 9-9/10"},
      {"bytes=4-", "456789", "bytes 4-9/10"},
      {"bytes=-3", "789", "bytes 7-9/10"},
      {"bytes=-99", "0123456789", "bytes 0-9/10"},
      {"Bytes=8-99999999999999999999999", "89", "bytes 8-9/10"},
  };
  for (const auto& one : kCases) {
    const HttpResponse response = Apply(one.range);
    EXPECT_EQ(response.status, kPartialContent) << one.range;
    EXPECT_EQ(response.body, one.body) << one.range;
    EXPECT_EQ(response.headers.at("Content-Range"), one.content_range);
  }
}

TEST(ByteRangeTest, TellsTheSizeIfNothingIsThere) {
  for (const char* range :
       {"bytes=10-", "bytes=10-12", "bytes=-0",
        "bytes=99999999999999999999-99999999999999999999"}) {
    const HttpResponse response = Apply(range);
    EXPECT_EQ(response.status, kRangeNotSatisfiable) << range;
    EXPECT_EQ(response.headers.at("Content-Range"), "bytes */10") << range;
  }
}

TEST(ByteRangeTest, IgnoresAllElse) {
  for (const char* range :
       {"", "bytes", "bytes=", "bytes=-", "bytes=a-b", "bytes=1", "bytes=5-2",
        "bytes=0-1,3-4", "bytes=0-,0-,0-", "bytes=+1-2", "bytes=1-2x",
        "rows=0-3", "bytes=0x1-2"}) {
    const HttpResponse response = Apply(range);
    EXPECT_EQ(response.status, kOk) << range;
    EXPECT_EQ(response.body.size(), 10u) << range;
    EXPECT_EQ(response.headers.count("Content-Range"), 0u) << range;
  }
  for (const char* method : {"HEAD", "POST", "PUT", "DELETE"}) {
    EXPECT_EQ(Apply("bytes=0-3", method).status, kOk) << method;
  }
  for (const int status : {kCreated, kBadRequest, kNotFound, kUnavailable}) {
    EXPECT_EQ(Apply("bytes=0-3", "GET", status).status, status);
    EXPECT_EQ(Apply("bytes=0-3", "GET", status).body.size(), 10u);
  }
}

TEST(ByteRangeTest, IgnoresARangeOfAnotherVersion) {
  HttpRequest request;
  request.method = "GET";
  request.headers = {{"range", "bytes=0-3"}, {"if-range", "\"1\""}};
  HttpResponse response;
  response.body = "0123456789";
  ApplyRange(request, &response);
  EXPECT_EQ(response.status, kOk);
}

}  // namespace
}  // namespace kg_engine
