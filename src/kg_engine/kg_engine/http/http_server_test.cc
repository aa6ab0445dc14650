#include "kg_engine/http/http_server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "kg_base/common/input_error.h"

namespace kg_engine {
namespace {

using kg_engine::HttpRequest;
using kg_engine::HttpResponse;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

// A client that can misbehave.
class Client {
 public:
  explicit Client(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    is_connected_ = connect(socket_, reinterpret_cast<sockaddr*>(&address),
                            sizeof address) == 0;
  }
  ~Client() { close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  bool is_connected() const { return is_connected_; }
  Client& Send(const std::string& text) {
    std::size_t sent = 0;
    while (sent < text.size()) {
      const ssize_t count =
          send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) break;  // The server closed the connection.
      sent += static_cast<std::size_t>(count);
    }
    return *this;
  }
  Client& SayNoMore() {
    shutdown(socket_, SHUT_WR);
    return *this;
  }
  // Reads until the server closes.
  std::string ReadAll() {
    std::string all;
    char block[4096];
    ssize_t count = 0;
    while ((count = recv(socket_, block, sizeof block, 0)) > 0) {
      all.append(block, static_cast<std::size_t>(count));
    }
    return all;
  }

 private:
  const int socket_;
  bool is_connected_ = false;
};

// Echoes the request.
HttpResponse Echo(const HttpRequest& request) {
  HttpResponse response;
  response.content_type = kg_engine::kPlainText;
  response.headers["X-Test"] = "yes";
  response.body = request.method + " " + request.path + " ? " + request.query +
                  " : " + request.body;
  return response;
}

HttpServerOptions Options() {
  HttpServerOptions options;
  options.body_bytes = 20000;
  return options;
}

std::string Exchange(int port, const std::string& text) {
  return Client(port).Send(text).ReadAll();
}

std::string Post(const std::string& body, const std::string& type) {
  return "POST /x HTTP/1.1\r\nHost: localhost\r\nContent-Type: " + type +
         "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
         body;
}

constexpr char kGet[] = "GET /a%20b?c=%2B HTTP/1.1\r\nHost: localhost\r\n\r\n";

TEST(HttpServerTest, HandsRequestsOverAsTheyAre) {
  const HttpServer server(Options(), Echo);
  const std::string get = Exchange(server.port(), kGet);
  EXPECT_THAT(get, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(get, HasSubstr("X-Test: yes\r\n"));
  EXPECT_THAT(get, HasSubstr("Connection: close\r\n"));
  EXPECT_THAT(get, HasSubstr("\r\n\r\nGET /a b ? c=%2B : "));
  for (const char* method : {"DELETE", "OPTIONS"}) {
    EXPECT_THAT(
        Exchange(server.port(), std::string(method) + " / HTTP/1.1\r\n\r\n"),
        HasSubstr(std::string(method) + " / ? "));
  }
  const std::string form = "application/x-www-form-urlencoded";
  const std::string long_form = "a=" + std::string(15000, 'x');
  EXPECT_THAT(Exchange(server.port(), Post(long_form, form)),
              HasSubstr(": " + long_form));
  EXPECT_THAT(Exchange(server.port(),
                       "PUT / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n"
                       "3\r\nabc\r\n2\r\nde\r\n0\r\n\r\n"),
              HasSubstr("PUT / ?  : abcde"));
}

TEST(HttpServerTest, LeavesTheBodyOutForHead) {
  const HttpServer server(Options(), Echo);
  const std::string head =
      Exchange(server.port(), "HEAD /abc HTTP/1.1\r\n\r\n");
  EXPECT_THAT(head, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(head, HasSubstr("Content-Length: 15\r\n"));
  EXPECT_EQ(head.substr(head.size() - 4), "\r\n\r\n");
}

TEST(HttpServerTest, SurvivesWhatIsNoHttp) {
  const HttpServer server(Options(), Echo);
  const std::string cases[] = {
      "",
      "\r\n\r\n",
      "hello\r\n\r\n",
      std::string(100, '\0') + "\r\n\r\n",
      "GET\r\n\r\n",
      "GET / HTTP/9.9\r\n\r\n",
      "NOTHING / HTTP/1.1\r\n\r\n",
      "GET / HTTP/1.1\r\nno colon\r\n\r\n",
      "GET /" + std::string(20000, 'a') + " HTTP/1.1\r\n\r\n",
      "GET / HTTP/1.1\r\nA: " + std::string(20000, 'a') + "\r\n\r\n",
      "GET /" + std::string(8000, 'a') + " HTTP/1.1\r\n\r\n",
      "GET /%00%ff%zz HTTP/1.1\r\n\r\n",
      "POST /" + std::string(8000, 'a') + " HTTP/1.1\r\n\r\n",
      "POST / HTTP/1.1\r\nContent-Length: -1\r\n\r\n",
      "POST / HTTP/1.1\r\nContent-Length: 99999999999999999999\r\n\r\nabc",
      "POST / HTTP/1.1\r\nContent-Length: 10\r\n\r\nabc",
      "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n",
      "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nffffffff\r\nabc",
      "POST / HTTP/1.1\r\nContent-Encoding: gzip\r\nContent-Length: 3\r\n\r\n"
      "abc",
      "POST / HTTP/1.1\r\nContent-Type: multipart/form-data; boundary=x\r\n"
      "Content-Length: 3\r\n\r\nabc",
  };
  for (const std::string& text : cases) {
    const std::string answer =
        Client(server.port()).Send(text).SayNoMore().ReadAll();
    if (!answer.empty()) {
      EXPECT_THAT(answer, StartsWith("HTTP/1.1 ")) << text.substr(0, 60);
    }
    EXPECT_THAT(Exchange(server.port(), kGet), StartsWith("HTTP/1.1 200"))
        << text.substr(0, 60);
  }
}

TEST(HttpServerTest, RefusesABodyThatIsTooLong) {
  std::atomic<bool> was_asked{false};
  const HttpServer server(Options(), [&was_asked](const HttpRequest& request) {
    was_asked = true;
    return Echo(request);
  });
  const std::string body(20001, 'x');
  EXPECT_THAT(Exchange(server.port(), Post(body, "text/plain")),
              StartsWith("HTTP/1.1 413"));
  std::string chunks = "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 30; ++i) {
    chunks += "400\r\n" + std::string(1024, 'x') + "\r\n";
  }
  EXPECT_THAT(Exchange(server.port(), chunks + "0\r\n\r\n"),
              StartsWith("HTTP/1.1 413"));
  EXPECT_FALSE(was_asked);
}

// Slow clients: silent, stopped in the headers, stopped in the body.
TEST(HttpServerTest, AnswersOthersWhileSomeAreSlow) {
  const HttpServer server(Options(), Echo);
  Client silent(server.port());
  Client half(server.port());
  half.Send("GET / HTTP/1.1\r\nHost: loc");
  Client body(server.port());
  body.Send("PUT / HTTP/1.1\r\nContent-Length: 10\r\n\r\nabc");
  EXPECT_THAT(Exchange(server.port(), kGet), StartsWith("HTTP/1.1 200"));
}

TEST(HttpServerTest, GivesUpOnAClientThatIsSlow) {
  HttpServerOptions options = Options();
  options.connections = 1;
  options.request_s = 0.2;
  const HttpServer server(options, Echo);
  Client silent(server.port());
  EXPECT_EQ(silent.ReadAll(), "");
  // Sending single bytes does not extend the deadline.
  Client dripping(server.port());
  std::atomic<bool> ended{false};
  std::thread drip([&] {
    dripping.Send("GET / HTTP/1.1\r\nA: ");
    while (!ended) {
      dripping.Send("x");
      std::this_thread::yield();
    }
  });
  dripping.ReadAll();
  ended = true;
  drip.join();
  EXPECT_THAT(Exchange(server.port(), kGet), StartsWith("HTTP/1.1 200"));
}

// A GET of one part; all else that asks for parts is answered whole, once.
TEST(HttpServerTest, SendsNoMoreThanTheAnswerForRanges) {
  const HttpServer server(Options(), Echo);
  const std::string part =
      Exchange(server.port(), "GET /abc HTTP/1.1\r\nRange: bytes=4-7\r\n\r\n");
  EXPECT_THAT(part, StartsWith("HTTP/1.1 206"));
  EXPECT_THAT(part, HasSubstr("Content-Range: bytes 4-7/14\r\n"));
  EXPECT_THAT(part, EndsWith("\r\n\r\n/abc"));
  EXPECT_THAT(
      Exchange(server.port(), "GET /abc HTTP/1.1\r\nRange: bytes=90-\r\n\r\n"),
      StartsWith("HTTP/1.1 416"));
  std::string many = "bytes=0-";
  for (int i = 0; i < 500; ++i) many += ", 0-";
  for (const std::string& range :
       {many, std::string("rows=1-2"), std::string("nonsense"),
        std::string("bytes=1-2\r\nRange: bytes=1-2")}) {
    const std::string whole = Exchange(
        server.port(), "GET /abc HTTP/1.1\r\nRange: " + range + "\r\n\r\n");
    EXPECT_THAT(whole, StartsWith("HTTP/1.1 200")) << range.substr(0, 40);
    EXPECT_THAT(whole, EndsWith("\r\n\r\nGET /abc ?  : "));
  }
  for (const char* method : {"POST", "PUT", "DELETE"}) {
    EXPECT_THAT(
        Exchange(server.port(), std::string(method) +
                                    " /abc HTTP/1.1\r\nRange: bytes=0-3\r\n"
                                    "Content-Length: 0\r\n\r\n"),
        StartsWith("HTTP/1.1 200"))
        << method;
  }
  const std::string head =
      Exchange(server.port(), "HEAD /abc HTTP/1.1\r\nRange: bytes=0-3\r\n\r\n");
  EXPECT_THAT(head, HasSubstr("Content-Length: 15\r\n"));
}

TEST(HttpServerTest, TellsAtOnceWhatIsWrongWithARequest) {
  HttpServerOptions options = Options();
  options.request_s = 60.0;
  const HttpServer server(options, Echo);
  const std::string put =
      "PUT / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n";
  EXPECT_THAT(Exchange(server.port(), put + "-1\r\na\r\n0\r\n\r\n"),
              StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(Exchange(server.port(), put + "ffffff\r\n"),
              StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(Exchange(server.port(), "PUT / HTTP/1.1\r\n\r\n"),
              EndsWith("PUT / ?  : "));
}

// They may neither use up descriptors nor keep others out for long.
TEST(HttpServerTest, AnswersOthersWhileManyAreIdle) {
  HttpServerOptions options = Options();
  options.connections = 2;
  options.waiting = 3;
  options.crowded_s = 0.05;
  options.request_s = 60.0;
  const HttpServer server(options, Echo);
  std::vector<std::unique_ptr<Client>> idle;
  for (int i = 0; i < 20; ++i) {
    idle.push_back(std::make_unique<Client>(server.port()));
    if (i % 2 == 0) idle.back()->Send("GET / HT");
  }
  EXPECT_THAT(Exchange(server.port(), kGet), StartsWith("HTTP/1.1 200"));
}

TEST(HttpServerTest, LetsOnlySoManyInAtOnce) {
  HttpServerOptions options = Options();
  options.answers = 3;
  std::mutex mutex;
  std::condition_variable changed;
  int inside = 0;
  int most = 0;
  bool open = false;
  const HttpServer server(options, [&](const HttpRequest& request) {
    std::unique_lock<std::mutex> lock(mutex);
    most = std::max(most, ++inside);
    changed.notify_all();
    changed.wait(lock, [&] { return open; });
    --inside;
    return Echo(request);
  });
  std::vector<std::thread> clients;
  std::atomic<int> answered{0};
  for (int i = 0; i < 50; ++i) {
    clients.emplace_back([&] {
      if (Exchange(server.port(), kGet).rfind("HTTP/1.1 200", 0) == 0) {
        ++answered;
      }
    });
  }
  {
    std::unique_lock<std::mutex> lock(mutex);
    changed.wait(lock, [&] { return inside == 3; });
    open = true;
    changed.notify_all();
  }
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(answered, 50);
  EXPECT_EQ(most, 3);
}

TEST(HttpServerTest, RefusesAPortThatIsTaken) {
  const HttpServer server(Options(), Echo);
  HttpServerOptions same = Options();
  same.port = server.port();
  EXPECT_THROW(HttpServer(same, Echo), kg_base::InputError);
  EXPECT_THAT(Exchange(server.port(), kGet), StartsWith("HTTP/1.1 200"));
}

TEST(HttpServerTest, StopsWithSilentClients) {
  auto server = std::make_optional<HttpServer>(Options(), Echo);
  const int port = server->port();
  Client silent(port);
  EXPECT_THAT(Exchange(port, kGet), StartsWith("HTTP/1.1 200"));
  server.reset();
  EXPECT_EQ(silent.ReadAll(), "");
  EXPECT_FALSE(Client(port).is_connected());
  const HttpServer again(
      [port] {
        HttpServerOptions options = Options();
        options.port = port;
        return options;
      }(),
      Echo);
  EXPECT_THAT(Exchange(port, kGet), StartsWith("HTTP/1.1 200"));
}

}  // namespace
}  // namespace kg_engine
