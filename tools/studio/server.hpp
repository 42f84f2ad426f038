// The HTTP server of the studio: the page, and the API, behind the guard. cpp-httplib is included by server.cpp only.
#pragma once
#include <memory>
#include <stop_token>

#include "tools/studio/api.hpp"
#include "tools/studio/channel.hpp"
#include "tools/studio/guard.hpp"

namespace waymark::studio {

// Threads for requests that have arrived, and for large ones whose rest a thread waits for.
inline constexpr std::size_t most_whole = 32, most_large = 8;
inline constexpr std::size_t most_head = 65'536;  // bytes of a request before its body

class Server {
 public:
  // The API must outlive it.
  Server(Access access, Api& api, const Patience& patience = {});
  ~Server();
  // Begins to listen. access.port 0: any free port, which access() then names. Throws tools::UsageError when the
  // address cannot be listened on.
  void bind();
  const Access& access() const;
  void run(const std::stop_token& stop);  // until then, after bind()

  // Answers one request, whose connection is closed afterwards. Thread-safe.
  void serve(Channel& channel);

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace waymark::studio
