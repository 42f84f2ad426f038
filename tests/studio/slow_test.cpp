// Slow senders and takers, and a server whose patience is a second: what they hold, and for how long.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <thread>
#include <vector>

#include "libparser/model_file.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/studio/reception.hpp"
#include "tools/studio/server.hpp"

namespace waymark::studio {
namespace {

using namespace std::chrono_literals;
using Clock = SocketChannel::Clock;

// Two ends of a connection, the second one in the hands of a client.
struct Ends {
  int ours = -1, theirs = -1;
  Ends() {
    int both[2];
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, both), 0);
    ours = both[0], theirs = both[1];
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  ~Ends() { ::close(ours), ::close(theirs); }
};

std::string read_of(SocketChannel& channel) {  // until the end, or a "…" when the time is over
  std::string out;
  char c = 0;
  while (true) {
    const auto n = channel.receive(&c, 1);
    if (!n) return out + "…";
    if (*n == 0) return out;
    out += c;
  }
}

TEST(Channel, EndsWithTheSender) {
  const Ends ends;
  ASSERT_EQ(::send(ends.theirs, "all", 3, 0), 3);
  ::shutdown(ends.theirs, SHUT_WR);
  SocketChannel channel(ends.ours, Clock::now() + 10s, {});
  EXPECT_EQ(read_of(channel), "all");
}

TEST(Channel, GivesUpOnSilence) {
  const Ends ends;
  ASSERT_EQ(::send(ends.theirs, "half", 4, 0), 4);
  SocketChannel channel(ends.ours, Clock::now() + 10s, {.silence = 50ms});
  EXPECT_EQ(read_of(channel), "half…");
}

TEST(Channel, GivesUpOnAByteAtATime) {
  const Ends ends;
  const std::jthread sender([&](const std::stop_token& stop) {
    while (!stop.stop_requested() && ::send(ends.theirs, "x", 1, MSG_NOSIGNAL) == 1) std::this_thread::sleep_for(20ms);
  });
  const auto begin = Clock::now();
  SocketChannel channel(ends.ours, begin + 300ms, {});
  EXPECT_TRUE(read_of(channel).ends_with("x…"));
  EXPECT_GE(Clock::now() - begin, 300ms);
}

TEST(Channel, TakesWhatIsThereThoughItsTimeIsOver) {
  const Ends ends;
  ASSERT_EQ(::send(ends.theirs, "all", 3, 0), 3);
  ::shutdown(ends.theirs, SHUT_WR);
  SocketChannel channel(ends.ours, Clock::now() - 1h, {});
  EXPECT_EQ(read_of(channel), "all");
}

TEST(Channel, GivesUpOnATakerOfNothing) {
  const Ends ends;
  SocketChannel channel(ends.ours, Clock::now(), {.answer = 100ms});
  EXPECT_TRUE(channel.send("small"));
  EXPECT_FALSE(channel.send(std::string(std::size_t{1} << 24U, 'x')));
}

TEST(Arrival, IsWholeOnceTheHeadAndItsLengthAreThere) {
  const std::string head = "POST / HTTP/1.1\r\nHost: a\r\ncontent-LENGTH:  3 \r\n\r\n";
  for (std::size_t size = 0; size < head.size() + 3; ++size)
    EXPECT_EQ(arrival_of((head + "abc").substr(0, size)), std::nullopt) << size;
  for (const std::string& whole : {head + "abc", head + "abcd", std::string("GET / HTTP/1.1\r\n\r\n"),
                                   std::string("\r\n\r\n"), std::string("A\r\nContent-Length: -3\r\n\r\n")})
    EXPECT_EQ(arrival_of(whole), Arrival::Whole) << whole;
}

TEST(Arrival, IsLargeWhereTheRestIsWaitedFor) {
  const auto request = [](const std::string& field, std::size_t body) {
    return "POST / HTTP/1.1\r\n" + field + "\r\n\r\n" + std::string(body, 'x');
  };
  for (const char* field : {"Transfer-Encoding: chunked", "Expect: 100-continue"})
    EXPECT_EQ(arrival_of(request(field, 0)), Arrival::Large) << field;
  for (const char* length : {"30000", "99999999999999999999999"}) {
    const std::string field = std::string("Content-Length: ") + length;
    EXPECT_EQ(arrival_of(request(field, 10'000)), std::nullopt) << length;
    EXPECT_EQ(arrival_of(request(field, 10'000) + std::string(10'000, 'x')), Arrival::Large) << length;
  }
  EXPECT_EQ(arrival_of(std::string(Reception::most_waited_for, 'x')), Arrival::Large);
}

// A server of this process, and connections to it.
class Slow : public ::testing::Test {
 protected:
  static constexpr Patience patience{.request = 2'000ms, .large = 100ms, .silence = 1'000ms};

  void SetUp() override {
    server_.bind();
    thread_ = std::jthread([this](const std::stop_token& stop) { server_.run(stop); });
    EXPECT_EQ(status(ask(get())), 200);
  }

  int connected() const {
    const int out = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(server_.access().port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(out, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return out;
  }

  std::string host() const { return "Host: 127.0.0.1:" + std::to_string(server_.access().port) + "\r\n"; }
  std::string get() const { return "GET /api/maps HTTP/1.1\r\n" + host() + "\r\n"; }
  std::string post(const std::string& body) const {
    return "POST /api/formula HTTP/1.1\r\n" + host() +
           "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  }

  static int status(const std::string& answer) {
    return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9)) : 0;
  }

  // The answer to a request that is sent in so many parts, with pauses between them.
  std::string ask(const std::string& request, std::size_t parts = 1, std::chrono::milliseconds pause = 0ms) const {
    const int socket = connected();
    for (std::size_t i = 0; i < parts; ++i) {
      if (i > 0) std::this_thread::sleep_for(pause);
      const std::size_t from = request.size() * i / parts, to = request.size() * (i + 1) / parts;
      ::send(socket, request.data() + from, to - from, MSG_NOSIGNAL);
    }
    std::string answer, part(4'096, ' ');
    for (ssize_t n = 0; (n = ::recv(socket, part.data(), part.size(), 0)) > 0;)
      answer.append(part, 0, static_cast<std::size_t>(n));
    ::close(socket);
    return answer;
  }

  // The statuses that so many clients are answered with that send a head at once and then a byte every 50 ms.
  std::vector<int> drip(std::size_t clients, const std::string& head) const {
    std::vector<int> sockets, statuses;
    for (std::size_t i = 0; i < clients; ++i) {
      sockets.push_back(connected());
      ::send(sockets.back(), head.data(), head.size(), MSG_NOSIGNAL);
    }
    for (const auto until = Clock::now() + 20s; !sockets.empty() && Clock::now() < until;) {
      std::this_thread::sleep_for(50ms);
      std::erase_if(sockets, [&](int socket) {
        char said[64];
        ssize_t n = ::recv(socket, said, sizeof said, MSG_DONTWAIT);
        if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
          ::send(socket, "x", 1, MSG_NOSIGNAL);
          return false;
        }
        statuses.push_back(n > 0 ? status({said, static_cast<std::size_t>(n)}) : 0);
        return ::close(socket) == 0;
      });
    }
    for (const int socket : sockets) ::close(socket);
    return statuses;
  }

  Api api_{parser::load_grounder(WAYMARK_DATA_FOLDER "/models/encoder-decoder.waymark"), WAYMARK_DATA_FOLDER};
  Server server_{{.host = "127.0.0.1"}, api_, patience};
  std::jthread thread_;
};

TEST_F(Slow, PortIsNotShared) {
  Server second({.host = "127.0.0.1", .port = server_.access().port}, api_);
  EXPECT_THROW(second.bind(), tools::UsageError);
}

TEST_F(Slow, SendersShutNobodyOut) {
  constexpr std::size_t clients = 3 * most_whole;
  for (const std::string& begin : {std::string("GET / HTTP/1.1\r\nX"), post(std::string(10'000, ' ')).substr(0, 200)}) {
    std::vector<int> statuses;
    {
      const std::jthread others([&] { statuses = drip(clients, begin); });
      std::this_thread::sleep_for(300ms);
      const auto asked = Clock::now();
      EXPECT_EQ(status(ask(get())), 200);
      EXPECT_LT(Clock::now() - asked, patience.request / 2) << "nobody waits for them";
    }
    EXPECT_EQ(statuses, std::vector<int>(clients, 408)) << begin;
  }
}

TEST_F(Slow, SendersOfLargeRequestsShutSuchOutUntilTheDeadline) {
  constexpr std::size_t clients = 3 * most_large;
  const std::string large = post(R"({"formula": "F sofa")" + std::string(100'000, ' ') + "}");
  std::vector<int> statuses;
  {
    const std::jthread others([&] { statuses = drip(clients, large.substr(0, 20'000)); });
    std::this_thread::sleep_for(300ms);
    const auto asked = Clock::now();
    EXPECT_EQ(status(ask(get())), 200);
    EXPECT_LT(Clock::now() - asked, patience.request / 2) << "others do not wait for them";
    EXPECT_EQ(status(ask(large)), 200);
    EXPECT_LT(Clock::now() - asked, patience.request + 3 * patience.large + 1s);
  }
  EXPECT_EQ(statuses, std::vector<int>(clients, 408));
}

TEST_F(Slow, SenderIsAnsweredWithinTheDeadline) {
  const std::string formula = ask(post(R"({"formula": "F sofa"})"), 8, 150ms);
  EXPECT_EQ(status(formula), 200);
  EXPECT_NE(formula.find("\"F sofa\""), std::string::npos) << formula;
}

TEST_F(Slow, SenderIsToldWhyItWasCutOff) {
  const std::string cut = ask(get().substr(0, 20));
  EXPECT_EQ(status(cut), 408);
  EXPECT_NE(cut.find(R"({"error":{"kind":"request","message":"the request did not arrive in time"}})"),
            std::string::npos)
      << cut;
}

}  // namespace
}  // namespace waymark::studio
