#include "tools/studio/channel.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace waymark::studio {
namespace {

bool try_again() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

bool SocketChannel::wait(short event, Clock::time_point until) const {
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    pollfd watched{socket_, event, 0};
    const int ready = ::poll(&watched, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (ready > 0) return true;
    if (left.count() <= 0 || (ready < 0 && errno != EINTR)) return false;
  }
}

std::optional<std::size_t> SocketChannel::receive(char* to, std::size_t size) {
  while (next_ == end_) {
    if (!wait(POLLIN, std::min(whole_by_, Clock::now() + patience_.silence))) return std::nullopt;
    const ssize_t n = ::recv(socket_, received_.data(), received_.size(), MSG_DONTWAIT);
    if (n < 0 && try_again()) continue;
    if (n <= 0) return 0;
    next_ = 0, end_ = static_cast<std::size_t>(n);
  }
  const std::size_t given = std::min(size, end_ - next_);
  std::memcpy(to, received_.data() + next_, given);
  next_ += given;
  return given;
}

bool SocketChannel::send(std::string_view bytes) {
  if (!taken_by_) taken_by_ = Clock::now() + patience_.answer;
  while (!bytes.empty()) {
    if (!wait(POLLOUT, *taken_by_)) return false;
    const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (n < 0 && try_again()) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::optional<std::size_t> TextChannel::receive(char* to, std::size_t size) {
  const std::size_t given = rest_.copy(to, size);
  rest_.remove_prefix(given);
  return given;
}

bool TextChannel::send(std::string_view bytes) {
  answer_ += bytes;
  return true;
}

}  // namespace waymark::studio
