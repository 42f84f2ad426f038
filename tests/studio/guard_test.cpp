// Who is let in: hosts, origins, sites, methods, types and tokens.
#include <gtest/gtest.h>

#include "tools/studio/guard.hpp"

namespace waymark::studio {
namespace {

const Access here{.host = "127.0.0.1", .port = 8321};
const Access abroad{.host = "0.0.0.0", .port = 8321, .token = "0123"};

RequestHead post() {
  return {.method = "POST",
          .path = "/api/run",
          .host = "127.0.0.1:8321",
          .origin = "http://127.0.0.1:8321",
          .fetch_site = "same-origin",
          .content_type = "application/json"};
}

int status(const Access& access, const RequestHead& head) {
  const auto refused = refusal(access, head);
  return refused ? refused->status : 200;
}

TEST(Guard, LetsItsOwnPageIn) {
  EXPECT_EQ(status(here, post()), 200);
  for (const char* host : {"localhost:8321", "[::1]:8321"}) {
    RequestHead head = post();
    head.host = host;
    const std::string origin = std::string("http://") + host;
    head.origin = origin;
    EXPECT_EQ(status(here, head), 200) << host;
  }
}

TEST(Guard, RefusesAnotherHost) {  // a name that was bound to 127.0.0.1 after its page was loaded
  for (const char* host : {"evil.example", "evil.example:8321", "127.0.0.1", "127.0.0.1:80",
                           "127.0.0.1.evil.example:8321", "192.168.0.7:8321", ""}) {
    RequestHead head = post();
    head.host = host, head.origin = "";
    EXPECT_EQ(status(here, head), 403) << host;
  }
}

TEST(Guard, RefusesAnotherOrigin) {
  for (const char* origin : {"http://evil.example", "null", "http://127.0.0.1:8322", "https://127.0.0.1:8321"}) {
    RequestHead head = post();
    head.origin = origin;
    EXPECT_EQ(status(here, head), 403) << origin;
  }
}

TEST(Guard, RefusesAnotherSite) {
  RequestHead head = post();
  head.fetch_site = "cross-site";
  EXPECT_EQ(status(here, head), 403);
}

TEST(Guard, RefusesFormsAndOtherMethods) {  // which another page may send without asking first
  for (const char* type : {"text/plain", "application/x-www-form-urlencoded", "multipart/form-data", ""}) {
    RequestHead head = post();
    head.content_type = type;
    EXPECT_EQ(status(here, head), 415) << type;
  }
  for (const char* method : {"PUT", "DELETE", "OPTIONS", "CONNECT"}) {
    RequestHead head = post();
    head.method = method;
    EXPECT_EQ(status(here, head), 405) << method;
  }
}

TEST(Guard, AsksForTheTokenBeyondThisMachine) {
  RequestHead head = post();
  head.host = "192.168.0.7:8321", head.origin = "http://192.168.0.7:8321";
  for (const char* authorization : {"", "Bearer ", "Bearer 0124", "Bearer 01234", "0123"}) {
    head.authorization = authorization;
    EXPECT_EQ(status(abroad, head), 401) << authorization;
  }
  head.authorization = "Bearer 0123";
  EXPECT_EQ(status(abroad, head), 200);
  head.host = "evil.example:8321", head.origin = "";
  EXPECT_EQ(status(abroad, head), 403);
}

TEST(Guard, MakesANewTokenEachTime) {
  const std::string token = new_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_NE(token, new_token());
  EXPECT_EQ(address_of({.host = "::", .port = 80, .token = token}), "http://[::]:80/#token=" + token);
}

}  // namespace
}  // namespace waymark::studio
