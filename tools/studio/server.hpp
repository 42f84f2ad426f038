// The HTTP server of the studio: the page, and the API, behind the guard. cpp-httplib is included by server.cpp only.
#pragma once
#include <memory>
#include <stop_token>

#include "tools/studio/api.hpp"
#include "tools/studio/guard.hpp"

namespace waymark::studio {

class Server {
 public:
  // Both must outlive it. access.port 0: any free port, which access() then names. Throws RequestError when the address
  // cannot be listened on.
  Server(Access access, Api& api);
  ~Server();
  const Access& access() const;
  void run(const std::stop_token& stop);  // until then

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace waymark::studio
