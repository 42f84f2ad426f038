#include "tools/studio/server.hpp"

#include <httplib.h>

#include <algorithm>
#include <cstdint>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/studio/assets.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {
namespace {

// Connections that are served at a time: slow senders hold theirs. What is worked on at a time is limited in api.cpp.
constexpr std::size_t threads = 32;
constexpr int connections_in_wait = 512;
constexpr std::time_t seconds_to_send = 5;  // a request has to be here, and an answer to be taken

// Scripts and styles of our own only; nothing of the page may be shown inside another one.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

// The library compresses "application/json" at a level that takes ten times as long as the answer; it knows no types
// with parameters.
constexpr const char* json_type = "application/json; charset=utf-8";

RequestHead head_of(const httplib::Request& request, const std::string (&values)[5]) {
  return {request.method, request.path, values[0], values[1], values[2], values[3], values[4]};
}

std::optional<Refusal> refusal_of(const Access& access, const httplib::Request& request) {
  const std::string values[5] = {request.get_header_value("Host"), request.get_header_value("Origin"),
                                 request.get_header_value("Sec-Fetch-Site"), request.get_header_value("Content-Type"),
                                 request.get_header_value("Authorization")};
  return refusal(access, head_of(request, values));
}

std::string error_json(const std::string& kind, const std::string& message) {
  using tools::JsonObject;
  return JsonObject().add("error", JsonObject().add("kind", kind).add("message", message)).text();
}

}  // namespace

class Server::Listener {
 public:
  Listener(Access access, Api& api) : access_(std::move(access)), api_(api) {
    limit();
    answer();
    server_.set_socket_options([this](socket_t socket) {
      httplib::default_socket_options(socket);
      socket_ = socket;
    });
    const int port = access_.port == 0                                  ? server_.bind_to_any_port(access_.host)
                     : server_.bind_to_port(access_.host, access_.port) ? access_.port
                                                                        : -1;
    if (port <= 0)
      throw tools::UsageError("cannot listen on " + access_.host + ":" + std::to_string(access_.port) +
                              "; --port names another port, 0 any free one");
    access_.port = port;
    ::listen(socket_, connections_in_wait);  // the library has them wait in a queue of five
  }

  const Access& access() const { return access_; }

  void run(const std::stop_token& stop) {
    stop_ = stop;
    const std::stop_callback end(stop, [this] { server_.stop(); });
    if (!stop.stop_requested()) server_.listen_after_bind();
  }

 private:
  void limit() {
    server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server_.set_payload_max_length(SIZE_MAX);  // else a larger body is read to its end; see answer_post
    server_.set_read_timeout(seconds_to_send);
    server_.set_write_timeout(seconds_to_send);
    server_.set_keep_alive_max_count(1);  // so that what was not read of a body is not taken for another request
    server_.set_tcp_nodelay(true);
    server_.set_default_headers({{"Content-Security-Policy", content_policy},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"Cross-Origin-Opener-Policy", "same-origin"},
                                 {"Cache-Control", "no-store"}});
  }

  void answer() {
    using Next = httplib::Server::HandlerResponse;
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      const auto refused = refusal_of(access_, request);
      if (!refused) return Next::Unhandled;
      response.status = refused->status;
      response.set_content(error_json("refused", refused->reason), json_type);
      return Next::Handled;
    });
    const httplib::Server::HandlerWithResponse explain = [](const httplib::Request&, httplib::Response& response) {
      if (!response.body.empty()) return Next::Unhandled;
      const bool large = response.status == 413;
      response.set_content(error_json(large ? "too large" : "request",
                                      large ? "the request has more than 1 MiB" : "the request is not answered"),
                           json_type);
      return Next::Handled;
    };
    server_.set_error_handler(explain);
    const auto by_path = [this](const httplib::Request& request, httplib::Response& response) {
      request.path.starts_with("/api/") ? answer_api(request, "", response) : answer_page(request, response);
    };
    server_.Get(".*", by_path);
    server_.Post(".*", [this](const httplib::Request& request, httplib::Response& response,
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
    const std::string_view text = asset->text;  // as it is: what a provider writes is not compressed
    response.set_content_provider(text.size(), std::string(asset->type),
                                  [text](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                    return sink.write(text.data() + from, length);
                                  });
  }

  Access access_;
  Api& api_;
  std::stop_token stop_;
  socket_t socket_ = INVALID_SOCKET;  // that listens
  httplib::Server server_;
};

Server::Server(Access access, Api& api) : listener_(std::make_unique<Listener>(std::move(access), api)) {}
Server::~Server() = default;
const Access& Server::access() const { return listener_->access(); }
void Server::run(const std::stop_token& stop) { listener_->run(stop); }

}  // namespace waymark::studio
