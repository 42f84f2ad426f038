#include "tools/studio/reception.hpp"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <vector>

namespace waymark::studio {
namespace {

constexpr std::size_t too_long = std::size_t{1} << 40U;  // longer than any request; its sum with others is a number
constexpr int milliseconds_between_looks = 100;          // for those whose time is over

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  return from == std::string_view::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") + 1 - from);
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

}  // namespace

std::optional<Arrival> arrival_of(std::string_view beginning) {
  constexpr std::string_view end_of_head = "\n\r\n";
  const std::size_t end = beginning.find(end_of_head);
  std::size_t wanted = SIZE_MAX;
  if (end != std::string_view::npos) {
    wanted = end + end_of_head.size();
    std::string_view head = beginning.substr(0, end);
    while (!head.empty()) {
      const std::string_view line = head.substr(0, head.find('\n'));
      head.remove_prefix(std::min(head.size(), line.size() + 1));
      const std::size_t colon = std::min(line.size(), line.find(':'));
      const std::string name = lower(trimmed(line.substr(0, colon)));
      if (name == "transfer-encoding" || name == "expect") return Arrival::Large;
      if (name != "content-length") continue;
      const std::string_view value = trimmed(line.substr(std::min(line.size(), colon + 1)));
      std::size_t length = 0;
      const auto read = std::from_chars(value.data(), value.data() + value.size(), length);
      wanted += read.ec == std::errc::result_out_of_range ? too_long : std::min(length, too_long);
    }
  }
  if (wanted <= beginning.size()) return Arrival::Whole;
  if (beginning.size() >= Reception::most_waited_for) return Arrival::Large;
  return std::nullopt;
}

Reception::Reception(const Patience& patience, Serve serve)
    : patience_(patience),
      serve_(std::move(serve)),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      beginning_(most_waited_for, '\0') {
  epoll_event event{};
  event.events = EPOLLIN, event.data.fd = wake_;
  ::epoll_ctl(epoll_, EPOLL_CTL_ADD, wake_, &event);
  thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

Reception::~Reception() {
  thread_.request_stop();
  ::eventfd_write(wake_, 1);
  thread_.join();
  for (const auto& [socket, waiting] : waiting_) ::close(socket);
  ::close(wake_);
  ::close(epoll_);
}

void Reception::admit(int socket) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  epoll_event event{};
  event.events = EPOLLIN | EPOLLRDHUP | EPOLLET, event.data.fd = socket;
  if (::epoll_ctl(epoll_, EPOLL_CTL_ADD, socket, &event) != 0) {
    ::close(socket);
    return;
  }
  waiting_.insert_or_assign(socket, Waiting{now, now});
  ::eventfd_write(wake_, 1);
}

void Reception::watch(const std::stop_token& stop) {
  std::array<epoll_event, 64> events{};
  bool any = false;
  while (!stop.stop_requested()) {
    const int n =
        ::epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), any ? milliseconds_between_looks : -1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(n, 0)); ++i) {
      eventfd_t times = 0;
      if (events[i].data.fd == wake_)
        ::eventfd_read(wake_, &times);
      else
        look(events[i].data.fd, (events[i].events & (EPOLLRDHUP | EPOLLHUP | EPOLLERR)) != 0);
    }
    dismiss_late();
    const std::lock_guard lock(mutex_);
    any = !waiting_.empty();
  }
}

void Reception::look(int socket, bool ended) {
  const std::lock_guard lock(mutex_);
  const auto found = waiting_.find(socket);
  if (found == waiting_.end()) return;
  found->second.heard = Clock::now();
  const ssize_t n = ::recv(socket, beginning_.data(), beginning_.size(), MSG_PEEK | MSG_DONTWAIT);
  const std::string_view beginning(beginning_.data(), n > 0 ? static_cast<std::size_t>(n) : 0);
  if (ended)
    leave(socket, Arrival::Whole);
  else if (const auto arrival = arrival_of(beginning))
    leave(socket, *arrival);
}

void Reception::dismiss_late() {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  std::vector<int> late;
  for (const auto& [socket, waiting] : waiting_)
    if (waiting.admitted + patience_.request <= now || waiting.heard + patience_.silence <= now) late.push_back(socket);
  for (const int socket : late) leave(socket, Arrival::Late);
}

void Reception::leave(int socket, Arrival arrival) {
  const auto admitted = waiting_.at(socket).admitted;
  waiting_.erase(socket);
  ::epoll_ctl(epoll_, EPOLL_CTL_DEL, socket, nullptr);
  serve_(socket, arrival, admitted);
}

}  // namespace waymark::studio
