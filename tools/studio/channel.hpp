// The two ends of one request: where its bytes come from, and where those of its answer go.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace waymark::studio {

class Channel {
 public:
  virtual ~Channel() = default;
  // At most `size` bytes of the request; 0 at its end; nothing when its sender has used up the time.
  virtual std::optional<std::size_t> receive(char* to, std::size_t size) = 0;
  virtual bool send(std::string_view bytes) = 0;  // all of them, or false
};

// How long one request may take.
struct Patience {
  std::chrono::milliseconds request{10'000};  // for head and body together, since the connection was accepted
  std::chrono::milliseconds large{1'000};     // since a thread waits for the rest of a large one, where that is longer
  std::chrono::milliseconds silence{5'000};   // between two parts of a request
  std::chrono::milliseconds answer{10'000};   // for the answer to be taken
};

// Over a connected socket, which stays open.
class SocketChannel : public Channel {
 public:
  using Clock = std::chrono::steady_clock;
  // The request is whole by that time; what is there already is received later too.
  SocketChannel(int socket, Clock::time_point whole_by, const Patience& patience)
      : socket_(socket), patience_(patience), whole_by_(whole_by) {}
  std::optional<std::size_t> receive(char* to, std::size_t size) override;
  bool send(std::string_view bytes) override;

 private:
  bool wait(short event, Clock::time_point until) const;

  const int socket_;
  const Patience patience_;
  const Clock::time_point whole_by_;
  std::optional<Clock::time_point> taken_by_;  // once something of the answer was sent
  std::array<char, 16'384> received_;          // of which [next_, end_) is still to be handed out
  std::size_t next_ = 0, end_ = 0;
};

// Over texts, without a socket: for tests.
class TextChannel : public Channel {
 public:
  explicit TextChannel(std::string_view request) : rest_(request) {}
  std::optional<std::size_t> receive(char* to, std::size_t size) override;
  bool send(std::string_view bytes) override;
  const std::string& answer() const { return answer_; }

 private:
  std::string_view rest_;
  std::string answer_;
};

}  // namespace waymark::studio
