// `waymark serve` as a process: the page, the guard and the limits over real connections.
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "tests/support/sanitizers.hpp"

namespace {

using nlohmann::json;
using waymark::testing::signals_wait;

// `waymark serve --port 0`, ended with the test.
class Serving : public ::testing::Test {
 protected:
  void SetUp() override {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[0]), ::close(ends[1]);
      ::execl(WAYMARK_EXECUTABLE, WAYMARK_EXECUTABLE, "serve", "--port", "0", nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    char c = 0;
    while (::read(ends[0], &c, 1) == 1 && c != '\n') said_ += c;
    ::close(ends[0]);
    const auto colon = said_.rfind(':');
    ASSERT_NE(colon, std::string::npos) << said_;
    port_ = std::stoi(said_.substr(colon + 1));
    idle_ = connected();
  }

  void TearDown() override {
    ::kill(process_, signals_wait ? SIGKILL : SIGINT);
    int status = 0;
    ::waitpid(process_, &status, 0);
    ::close(idle_);
    if (signals_wait) return;
    EXPECT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0) << "Ctrl-C is how the studio ends";
  }

  int connected() const {
    const int out = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(out, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return out;
  }

  httplib::Client client() const { return httplib::Client("127.0.0.1", port_); }

  int idle_ = -1;  // a connection on which nothing is sent
  std::string said_;
  pid_t process_ = -1;
  int port_ = 0;
};

TEST_F(Serving, ShowsThePageAndNothingElse) {
  auto http = client();
  const auto page = http.Get("/");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_NE(page->body.find("waymark studio"), std::string::npos);
  EXPECT_NE(page->get_header_value("Content-Security-Policy").find("default-src 'none'"), std::string::npos);
  for (const char* path :
       {"/../../../../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/index.html/",
        "/studio.css", "/data/maps/grid.json", "/page/studio.js", "/.git/config"}) {
    const auto answer = http.Get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 404) << path;
    EXPECT_EQ(answer->body, "not found\n") << path;
  }
}

TEST_F(Serving, RefusesForeignHostsAndOrigins) {
  auto http = client();
  const std::string body = R"({"formula": "F sofa"})";
  const auto status = [&](const httplib::Headers& headers) {
    const auto answer = http.Post("/api/formula", headers, body, "application/json");
    return answer ? answer->status : 0;
  };
  EXPECT_EQ(status({}), 200);
  EXPECT_EQ(status({{"Host", "evil.example"}}), 403);
  EXPECT_EQ(status({{"Origin", "http://evil.example"}}), 403);
  EXPECT_EQ(status({{"Origin", "null"}}), 403);
  EXPECT_EQ(status({{"Sec-Fetch-Site", "cross-site"}}), 403);
  const auto form = http.Post("/api/formula", body, "text/plain");
  ASSERT_TRUE(form);
  EXPECT_EQ(form->status, 415);
  const auto page = http.Get("/", {{"Host", "evil.example:80"}});
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 403);
}

TEST_F(Serving, RefusesBodiesThatAreTooLarge) {
  constexpr std::size_t most_sent = 64 << 20;  // of a gigabyte: it is cut off soon after its first MiB
  auto http = client();
  const auto large = http.Post("/api/maps", std::string(2'000'000, ' '), "application/json");
  if (large) {  // else the connection was closed before all was sent
    EXPECT_EQ(large->status, 413);
    EXPECT_EQ(json::parse(large->body)["error"]["kind"], "too large");
  }
  const std::string host = "Host: 127.0.0.1:" + std::to_string(port_) + "\r\nContent-Type: application/json\r\n";
  const std::string block(1 << 16, ' ');
  for (const std::string length : {"Content-Length: 1073741824", "Transfer-Encoding: chunked"}) {
    for (const std::string path : {"/api/maps", "/nothing"}) {
      const int socket = connected();
      std::size_t sent = 0;
      const auto send_all = [&](const std::string& text) {
        const ssize_t n = ::send(socket, text.data(), text.size(), MSG_NOSIGNAL);
        sent += n > 0 ? static_cast<std::size_t>(n) : 0;
        return n > 0;
      };
      ASSERT_TRUE(send_all("POST " + path + " HTTP/1.1\r\n" + host + length + "\r\n\r\n"));
      while (sent < most_sent && send_all(length.starts_with("T") ? "10000\r\n" + block + "\r\n" : block)) {
      }
      EXPECT_LT(sent, most_sent) << path << ' ' << length;
      ::close(socket);
    }
  }
  auto again = client();
  const auto maps = again.Get("/api/maps");
  ASSERT_TRUE(maps);
  EXPECT_EQ(json::parse(maps->body)["maps"], (json{"grid", "jelly", "l"}));
}

}  // namespace
