// Where connections wait until their request is there. One thread watches all of them, so that a slow sender holds a
// file descriptor and no thread. What was sent stays with the kernel until then.
#pragma once
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "tools/studio/channel.hpp"

namespace waymark::studio {

// What has arrived of a request when its connection leaves the reception.
enum class Arrival {
  Whole,  // all that is going to
  Large,  // more than fits here, or a beginning that does not tell its length: somebody has to wait for the rest
  Late,   // half of it, and the time is over
};

class Reception {
 public:
  using Clock = SocketChannel::Clock;
  static constexpr std::size_t most_waited_for = 16'384;  // bytes of a request

  // The socket, whose owner is the callee from then on, and when it was admitted. Called in the thread that watches.
  using Serve = std::function<void(int socket, Arrival arrival, Clock::time_point admitted)>;

  Reception(const Patience& patience, Serve serve);
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;
  ~Reception();  // closes what still waits

  void admit(int socket);  // which is closed where it cannot be watched

 private:
  struct Waiting {
    Clock::time_point admitted, heard;
  };
  void watch(const std::stop_token& stop);
  void look(int socket, bool ended);
  void dismiss_late();
  void leave(int socket, Arrival arrival);  // the mutex is held

  const Patience patience_;
  const Serve serve_;
  const int epoll_, wake_;
  std::mutex mutex_;
  std::map<int, Waiting> waiting_;  // by socket
  std::string beginning_;           // of the request that is looked at
  std::jthread thread_;
};

// What these first bytes of a request are; nothing while they are half of it.
std::optional<Arrival> arrival_of(std::string_view beginning);

}  // namespace waymark::studio
