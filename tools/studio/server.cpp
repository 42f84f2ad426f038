#include "tools/studio/server.hpp"

#include <httplib.h>

#include <algorithm>
#include <cstdint>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/studio/assets.hpp"
#include "tools/studio/reception.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {
namespace {

constexpr int connections_in_wait = 512;  // that are not accepted yet
// Bytes of a request with the framing of its chunks. What is worked on at a time is limited in api.cpp.
constexpr std::size_t most_request = most_head + 2 * most_body;

// The library matches a path with a regular expression that takes 270 bytes of the stack for each of its bytes.
constexpr std::size_t most_path = 256;

// Scripts and styles of our own only; nothing of the page may be shown inside another one.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr const char* json_type = "application/json; charset=utf-8";

constexpr const char* guarded_fields[] = {"Host", "Origin", "Sec-Fetch-Site", "Content-Type", "Authorization"};

std::optional<Refusal> refusal_of(const Access& access, const httplib::Request& request) {
  if (request.path.size() > most_path) return Refusal{414, "the path of the request is too long"};
  // Without either, the library reads up to the end of the connection.
  if (request.method == "POST" && !request.has_header("Content-Length") && !request.has_header("Transfer-Encoding"))
    return Refusal{411, "the request does not say its length"};
  std::string values[std::size(guarded_fields)];
  for (std::size_t i = 0; i < std::size(guarded_fields); ++i) {
    const char* field = guarded_fields[i];
    if (request.get_header_value_count(field) > 1)
      return Refusal{400, "the request has more than one " + std::string(field)};
    values[i] = request.get_header_value(field);
  }
  return refusal(access, {request.method, request.path, values[0], values[1], values[2], values[3], values[4]});
}

std::string error_json(const std::string& kind, const std::string& message) {
  using tools::JsonObject;
  return JsonObject().add("error", JsonObject().add("kind", kind).add("message", message)).text();
}

// What the library reads a request from. Once a limit of time or size is met the library reads and writes nothing
// more: what it answers to half a request is dropped, for refused() to be answered instead.
class RequestStream : public httplib::Stream {
 public:
  explicit RequestStream(Channel& channel) : channel_(channel) {}

  const std::optional<ApiAnswer>& refused() const { return refused_; }

  bool is_readable() const override { return !refused_; }
  bool is_writable() const override { return !broken_; }
  ssize_t read(char* to, std::size_t size) override {
    if (refused_) return -1;
    const auto n = channel_.receive(to, size);
    if (!n)
      refused_ = {408, error_json("request", "the request did not arrive in time")};
    else if (!within_limits({to, *n}))
      refused_ = in_head_ ? ApiAnswer{431, error_json("too large", "the head of the request has more than 64 KiB")}
                          : ApiAnswer{413, error_json("too large", "the request has more than 1 MiB")};
    return refused_ ? -1 : static_cast<ssize_t>(*n);
  }
  ssize_t write(const char* from, std::size_t size) override {
    broken_ = broken_ || (!refused_ && !channel_.send({from, size}));
    return broken_ ? -1 : static_cast<ssize_t>(size);
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return 0; }  // the library refuses large ones, for the sake of select()

 private:
  bool within_limits(std::string_view bytes) {
    read_ += bytes.size();
    for (std::size_t i = 0; in_head_ && i < bytes.size(); ++i) {  // of a head, one byte at a time is read
      last_ = (last_ << 8U | static_cast<unsigned char>(bytes[i])) & 0xffffffU;
      in_head_ = last_ != 0x0a0d0aU;  // an empty line ends the head
    }
    return read_ <= (in_head_ ? most_head : most_request);
  }

  Channel& channel_;
  std::size_t read_ = 0;
  bool in_head_ = true, broken_ = false;
  std::uint32_t last_ = 0;  // three bytes of the head
  std::optional<ApiAnswer> refused_;
};

void send(Channel& channel, const ApiAnswer& answer) {
  channel.send("HTTP/1.1 " + std::to_string(answer.status) + " \r\nConnection: close\r\nContent-Type: " + json_type +
               "\r\nContent-Length: " + std::to_string(answer.json.size()) + "\r\n\r\n" + answer.json);
}

// A reception with threads behind it: none of those that serve whole requests waits for a slow sender.
class Hall {
 public:
  using Serve = std::function<void(SocketChannel&)>;
  Hall(const Patience& patience, Serve serve) : patience_(patience), serve_(std::move(serve)) {
    reception_.emplace(patience, [this](int socket, Arrival arrival, auto admitted) {
      (arrival == Arrival::Large ? large_ : whole_).enqueue([=, this] { serve_and_close(socket, arrival, admitted); });
    });
  }
  Hall(const Hall&) = delete;
  Hall& operator=(const Hall&) = delete;
  ~Hall() {
    reception_.reset();  // it hands connections to the others
    whole_.shutdown();
    large_.shutdown();
  }
  void admit(int socket) { reception_->admit(socket); }

 private:
  void serve_and_close(int socket, Arrival arrival, SocketChannel::Clock::time_point admitted) const {
    auto whole_by = admitted;
    if (arrival == Arrival::Large)
      whole_by = std::max(admitted + patience_.request, SocketChannel::Clock::now() + patience_.large);
    SocketChannel channel(socket, whole_by, patience_);
    serve_(channel);
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
  }

  const Patience patience_;
  const Serve serve_;
  httplib::ThreadPool whole_{most_whole}, large_{most_large};
  std::optional<Reception> reception_;
};

}  // namespace

class Server::Listener : httplib::Server {
 public:
  Listener(Access access, Api& api, const Patience& patience)
      : access_(std::move(access)), api_(api), patience_(patience) {
    limit();
    answer();
  }

  void bind() {
    const int port = access_.port == 0                          ? bind_to_any_port(access_.host)
                     : bind_to_port(access_.host, access_.port) ? access_.port
                                                                : -1;
    if (port <= 0)
      throw tools::UsageError("cannot listen on " + access_.host + ":" + std::to_string(access_.port) +
                              "; --port names another port, 0 any free one");
    access_.port = port;
    hall_.emplace(patience_, [this](SocketChannel& channel) { serve(channel); });
    ::listen(svr_sock_, connections_in_wait);  // the library has them wait in a queue of five
  }

  const Access& access() const { return access_; }

  void run(const std::stop_token& stop) {
    stop_ = stop;
    const std::stop_callback end(stop, [this] { httplib::Server::stop(); });
    if (!stop.stop_requested()) listen_after_bind();
  }

  void serve(Channel& channel) {
    RequestStream stream(channel);
    bool closed = false;
    process_request(stream, true, closed, [](httplib::Request& request) {
      request.ranges.clear();                    // what is asked for a thousand times over is sent once, whole
      request.headers.erase("Accept-Encoding");  // the library compresses at a level that takes ten times as long
    });
    if (stream.refused()) send(channel, *stream.refused());
  }

 private:
  bool process_and_close_socket(socket_t socket) override {
    hall_->admit(socket);
    return true;
  }

  void limit() {
    new_task_queue = [] { return new httplib::ThreadPool(1); };  // which hands connections on
    set_payload_max_length(SIZE_MAX);  // else a larger body is read to its end; see answer_post
    set_tcp_nodelay(true);
    set_socket_options([](socket_t socket) {  // the library lets a second studio share the port, unseen
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    set_default_headers({{"Content-Security-Policy", content_policy},
                         {"X-Content-Type-Options", "nosniff"},
                         {"Referrer-Policy", "no-referrer"},
                         {"Cross-Origin-Resource-Policy", "same-origin"},
                         {"Cross-Origin-Opener-Policy", "same-origin"},
                         {"Cache-Control", "no-store"}});
  }

  void answer() {
    using Next = HandlerResponse;
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      const auto refused = refusal_of(access_, request);
      if (!refused) return Next::Unhandled;
      response.status = refused->status;
      response.set_content(error_json("refused", refused->reason), json_type);
      return Next::Handled;
    });
    const HandlerWithResponse explain = [](const httplib::Request&, httplib::Response& response) {
      if (!response.body.empty()) return Next::Unhandled;
      const bool large = response.status == 413;
      response.set_content(error_json(large ? "too large" : "request",
                                      large ? "the request has more than 1 MiB" : "the request is not answered"),
                           json_type);
      return Next::Handled;
    };
    set_error_handler(explain);
    const auto by_path = [this](const httplib::Request& request, httplib::Response& response) {
      request.path.starts_with("/api/") ? answer_api(request, "", response) : answer_page(request, response);
    };
    Get(".*", by_path);
    Post(".*", [this](const httplib::Request& request, httplib::Response& response,
                      const httplib::ContentReader& read) { answer_post(request, response, read); });
  }

  // A body that is too large is cut off where it becomes so: its sender may have a gigabyte more.
  void answer_post(const httplib::Request& request, httplib::Response& response, const httplib::ContentReader& read) {
    if (request.is_multipart_form_data()) {
      response.status = 415;
      return;
    }
    std::string body;
    const bool whole = read([&](const char* data, std::size_t size) {
      body.append(data, size);
      return body.size() <= most_body;
    });
    if (whole)
      answer_api(request, body, response);
    else
      response.status = body.size() > most_body ? 413 : 400;
  }

  void answer_api(const httplib::Request& request, const std::string& body, httplib::Response& response) {
    const ApiAnswer answer = api_.answer(request.method, request.path, body, stop_);
    response.status = answer.status;
    response.set_content(answer.json, json_type);
  }

  // The files of the page are looked up among those that are embedded: no path leads to the machine.
  static void answer_page(const httplib::Request& request, httplib::Response& response) {
    const auto all = assets();
    const auto asset = std::find_if(all.begin(), all.end(), [&](const Asset& a) { return a.path == request.path; });
    if (asset == all.end()) {
      response.status = 404;
      response.set_content("not found\n", "text/plain");
      return;
    }
    response.set_content(std::string(asset->text), std::string(asset->type));
  }

  Access access_;
  Api& api_;
  const Patience patience_;
  std::stop_token stop_;
  std::optional<Hall> hall_;  // last: its threads use all of the above
};

Server::Server(Access access, Api& api, const Patience& patience)
    : listener_(std::make_unique<Listener>(std::move(access), api, patience)) {}
Server::~Server() = default;
void Server::bind() { listener_->bind(); }
const Access& Server::access() const { return listener_->access(); }
void Server::run(const std::stop_token& stop) { listener_->run(stop); }
void Server::serve(Channel& channel) { listener_->serve(channel); }

}  // namespace waymark::studio
