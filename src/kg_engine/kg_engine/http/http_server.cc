#include "kg_engine/http/http_server.h"

#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_engine/http/request_reader.h"
#include "kg_engine/protocol/byte_range.h"

namespace kg_engine {
namespace {

using Clock = std::chrono::steady_clock;
using kg_engine::HttpRequest;
using kg_engine::HttpResponse;

constexpr char kLoopback[] = "127.0.0.1";
constexpr int kSlice_ms = 50;  // Poll interval of waiting threads for shutdown.
constexpr double kFarewell_s = 1.0;

Clock::duration ToDuration(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(seconds));
}

Clock::time_point In(double seconds) {
  return Clock::now() + ToDuration(seconds);
}

// One connection. Deadlines apply to reading as a whole and to writing as a
// whole, so that a slow client cannot hold a thread.
class DeadlineStream : public httplib::Stream {
 public:
  DeadlineStream(socket_t socket, double seconds,
                 const std::atomic<bool>* stopping)
      : socket_(socket),
        seconds_(seconds),
        stopping_(stopping),
        began_(Clock::now()),
        read_end_(In(seconds)) {}

  // While `is_crowded`, what is read must arrive within `seconds`; until
  // AllowFullTime().
  void LimitWhenCrowded(std::function<bool()> is_crowded, double seconds) {
    is_crowded_ = std::move(is_crowded);
    crowded_ = ToDuration(seconds);
  }
  void AllowFullTime() { is_crowded_ = nullptr; }

  // Read again before all else.
  void Unread(std::string text) {
    unread_ = std::move(text);
    unread_begin_ = 0;
  }

  using httplib::Stream::write;
  bool is_readable() const override {
    return unread_begin_ < unread_.size() || begin_ < filled_ ||
           Wait(POLLIN, read_end_);
  }
  bool is_writable() const override { return Wait(POLLOUT, write_end_); }
  ssize_t read(char* bytes, size_t size) override {
    is_writing_ = false;
    if (unread_begin_ < unread_.size()) {
      const size_t count = unread_.copy(bytes, size, unread_begin_);
      unread_begin_ += count;
      if (unread_begin_ == unread_.size()) {
        std::string().swap(unread_);  // Frees the memory of a long body.
        unread_begin_ = 0;
      }
      return static_cast<ssize_t>(count);
    }
    if (begin_ == filled_) {
      if (!Wait(POLLIN, read_end_)) return -1;
      const ssize_t got = recv(socket_, buffer_, sizeof buffer_, 0);
      if (got <= 0) return got;
      begin_ = 0;
      filled_ = static_cast<size_t>(got);
    }
    const size_t count = std::min(size, filled_ - begin_);
    std::copy_n(buffer_ + begin_, count, bytes);
    begin_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* bytes, size_t size) override {
    if (!is_writing_) write_end_ = In(seconds_);
    is_writing_ = true;
    if (!Wait(POLLOUT, write_end_)) return -1;
    return send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  }
  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    ip = kLoopback;
    port = 0;  // Unused.
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    ip = kLoopback;
    port = 0;
  }
  socket_t socket() const override { return socket_; }

  // Graceful close: closing with unread bytes would reset the connection and
  // discard the response.
  void SayGoodbye() {
    shutdown(socket_, SHUT_WR);
    const Clock::time_point end = In(kFarewell_s);
    while (Wait(POLLIN, end) && recv(socket_, buffer_, sizeof buffer_, 0) > 0) {
    }
  }

 private:
  bool IsLate(short event, Clock::time_point end) const {
    const Clock::time_point now = Clock::now();
    return now >= end || (event == POLLIN && is_crowded_ &&
                          now >= began_ + crowded_ && is_crowded_());
  }
  bool Wait(short event, Clock::time_point end) const {
    while (!*stopping_ && !IsLate(event, end)) {
      pollfd waiting{socket_, event, 0};
      const int ready = poll(&waiting, 1, kSlice_ms);
      if (ready > 0) return true;
      if (ready < 0 && errno != EINTR) return false;
    }
    return false;
  }

  const socket_t socket_;
  const double seconds_;
  const std::atomic<bool>* const stopping_;
  const Clock::time_point began_;
  const Clock::time_point read_end_;
  std::function<bool()> is_crowded_;
  Clock::duration crowded_{};
  std::string unread_;
  size_t unread_begin_ = 0;
  Clock::time_point write_end_;
  bool is_writing_ = false;
  char buffer_[16384];
  size_t begin_ = 0;
  size_t filled_ = 0;
};

}  // namespace

// Limits the number of concurrent callers; others wait.
class AnswerSlots {
 public:
  explicit AnswerSlots(int places) : places_(places) {}

  bool Enter(double patience_s) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!freed_.wait_until(lock, In(patience_s),
                           [this] { return places_ > 0; })) {
      return false;
    }
    --places_;
    return true;
  }
  void Leave() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++places_;
    }
    freed_.notify_one();
  }

 private:
  std::mutex mutex_;
  std::condition_variable freed_;
  int places_;
};

namespace {

// A pool of threads with a limit on waiting connections: unlike httplib's
// alone, which accepts any number and so uses up the process's descriptors.
class BoundedQueue : public httplib::TaskQueue {
 public:
  // Counts the waiting connections in `waiting`.
  BoundedQueue(int threads, int max_waiting, std::atomic<int>* waiting)
      : max_waiting_(max_waiting),
        waiting_(waiting),
        pool_(static_cast<std::size_t>(threads)) {}

  // Blocks the thread that accepts until there is room.
  void enqueue(std::function<void()> serve) override {
    std::unique_lock<std::mutex> lock(mutex_);
    begun_.wait(lock, [this] { return *waiting_ < max_waiting_; });
    ++*waiting_;
    pool_.enqueue([this, serve = std::move(serve)] {
      {
        const std::lock_guard<std::mutex> begun_lock(mutex_);
        --*waiting_;
      }
      begun_.notify_one();
      serve();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  const int max_waiting_;
  std::atomic<int>* const waiting_;
  std::mutex mutex_;
  std::condition_variable begun_;
  httplib::ThreadPool pool_;
};

HttpRequest FromHttplib(const httplib::Request& request, std::string body) {
  HttpRequest out;
  out.method = request.method;
  out.path = request.path;
  const std::size_t mark = request.target.find('?');
  if (mark != std::string::npos) {
    out.query = request.target.substr(mark + 1);
    out.query.resize(std::min(out.query.find('#'), out.query.size()));
  }
  for (const auto& [name, value] : request.headers) {
    std::string& all = out.headers[kg_base::ToLowerAscii(name)];
    all += (all.empty() ? "" : ", ") + value;
  }
  out.body = std::move(body);
  return out;
}

void ToHttplib(HttpResponse from, httplib::Response* to) {
  to->status = from.status;
  for (const auto& [name, value] : from.headers) to->set_header(name, value);
  if (from.content_type.empty()) return;
  to->set_content(std::move(from.body), from.content_type);
}

HttpResponse Refusal(int status, const std::string& why) {
  HttpResponse response;
  response.status = status;
  response.content_type = kg_engine::kPlainText;
  response.body = why + "\n";
  return response;
}

// A refusal of a request that httplib never sees. The reason phrase may be
// empty: RFC 9112, 4.
std::string FormatRefusal(const HttpResponse& refusal) {
  return "HTTP/1.1 " + std::to_string(refusal.status) +
         " \r\nContent-Type: " + refusal.content_type +
         "\r\nContent-Length: " + std::to_string(refusal.body.size()) +
         "\r\nConnection: close\r\n\r\n" + refusal.body;
}

// Unlike httplib, no SO_REUSEPORT: two servers would share one port.
void SetSocketOptions(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

class HttpServer::Listener : public httplib::Server {
 public:
  Listener(const HttpServerOptions& options, HttpServer::Handler handler)
      : options_(options),
        handler_(std::move(handler)),
        slots_(options.answers) {
    set_payload_max_length(options.body_bytes);
    set_socket_options(SetSocketOptions);
    new_task_queue = [this] {
      return new BoundedQueue(options_.connections, options_.waiting,
                              &waiting_);
    };
    RouteAll();
    Bind();
    thread_ = std::thread([this] { listen_after_bind(); });
    while (!is_running()) std::this_thread::yield();
  }

  ~Listener() override {
    stopping_ = true;
    stop();
    thread_.join();
  }

  int port() const { return port_; }

 private:
  void Bind() {
    port_ = options_.port == 0 ? bind_to_any_port(kLoopback)
            : bind_to_port(kLoopback, options_.port) ? options_.port
                                                     : -1;
    if (port_ > 0) return;
    throw kg_base::InputError("HTTP port " + std::to_string(options_.port) +
                              " of 127.0.0.1 cannot be had: another program "
                              "has it, or it is not allowed");
  }

  // Bodies are read here, because httplib limits forms to 8 KiB.
  void RouteAll() {
    set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          const bool has_body = request.method == "POST" ||
                                request.method == "PUT" ||
                                request.method == "PATCH";
          if (has_body) return HandlerResponse::Unhandled;
          ToHttplib(Answer(FromHttplib(request, "")), &response);
          return HandlerResponse::Handled;
        });
    const auto with_body = [this](const httplib::Request& request,
                                  httplib::Response& response,
                                  const httplib::ContentReader& reader) {
      AnswerWithBody(request, reader, &response);
    };
    Post(".*", HandlerWithContentReader(with_body));
    Put(".*", HandlerWithContentReader(with_body));
    Patch(".*", HandlerWithContentReader(with_body));
  }

  void AnswerWithBody(const httplib::Request& request,
                      const httplib::ContentReader& reader,
                      httplib::Response* response) {
    // Requests that httplib would decode itself.
    if (request.is_multipart_form_data() ||
        request.has_header("Content-Encoding")) {
      const int status = kg_engine::kUnsupportedMediaType;
      return ToHttplib(Refusal(status,
                               "expected a body as it is, neither "
                               "multipart nor compressed"),
                       response);
    }
    std::string body;
    const bool whole = reader([&](const char* bytes, size_t size) {
      body.append(bytes, size);
      return body.size() <= options_.body_bytes;
    });
    if (whole) {
      return ToHttplib(Answer(FromHttplib(request, std::move(body))), response);
    }
    const bool large = response->status == kg_engine::kContentTooLarge ||
                       body.size() > options_.body_bytes;
    const std::string limit = std::to_string(options_.body_bytes);
    ToHttplib(large ? Refusal(kg_engine::kContentTooLarge,
                              "the body is longer than the limit of " + limit +
                                  " bytes")
                    : Refusal(kg_engine::kRequestTimeout,
                              "the body did not arrive whole in time"),
              response);
  }

  HttpResponse Answer(const HttpRequest& request) {
    if (!slots_.Enter(options_.request_s)) {
      return Refusal(kg_engine::kUnavailable, "too many requests at once");
    }
    HttpResponse response = handler_(request);  // Does not throw.
    slots_.Leave();
    ApplyRange(request, &response);
    return response;
  }

  bool process_and_close_socket(socket_t socket) override {
    DeadlineStream stream(socket, options_.request_s, &stopping_);
    stream.LimitWhenCrowded([this] { return waiting_ > 0; },
                            options_.crowded_s);
    const bool done = Serve(&stream);
    if (done) stream.SayGoodbye();
    close(socket);
    return done;
  }

  // False if there was no request.
  bool Serve(DeadlineStream* stream) {
    RequestText request;
    try {
      request = Read(stream);
    } catch (const HttpError& error) {
      return stream->write(
                 FormatRefusal(Refusal(error.status(), error.what()))) > 0;
    }
    if (request.text.empty()) return false;
    stream->AllowFullTime();
    stream->Unread(std::move(request.text));
    bool is_closed = false;
    // httplib parses ranges before this hook, so it knows none; ApplyRange()
    // does. Parts are not compressed.
    return process_request(*stream, true, is_closed,
                           [&request](httplib::Request& parsed) {
                             if (request.range.empty()) return;
                             parsed.set_header("Range", request.range);
                             parsed.headers.erase("Accept-Encoding");
                           });
  }

  RequestText Read(DeadlineStream* stream) {
    RequestLimits limits;
    limits.body_bytes = options_.body_bytes;
    return ReadRequest(
        limits,
        [stream](char* bytes, std::size_t size) {
          return stream->read(bytes, size);
        },
        [stream](bool is_awaited) {
          stream->AllowFullTime();
          if (is_awaited) stream->write("HTTP/1.1 100 Continue\r\n\r\n");
        });
  }

  const HttpServerOptions options_;
  const HttpServer::Handler handler_;
  AnswerSlots slots_;
  std::atomic<bool> stopping_{false};
  std::atomic<int> waiting_{0};  // Connections without a thread yet.
  int port_ = -1;
  std::thread thread_;
};

HttpServer::HttpServer(const HttpServerOptions& options, Handler handler)
    : listener_(std::make_unique<Listener>(options, std::move(handler))) {}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return listener_->port(); }

}  // namespace kg_engine
