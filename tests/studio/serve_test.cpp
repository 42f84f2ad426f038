// One request at a time through the server, without a socket: what is refused before the API sees it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "libparser/model_file.hpp"
#include "tools/studio/request.hpp"
#include "tools/studio/server.hpp"

namespace waymark::studio {
namespace {

using nlohmann::json;

struct Answer {
  int status = 0;
  std::string head, body;
};

Answer answer(std::string_view request) {
  static Api api(parser::load_grounder(WAYMARK_DATA_FOLDER "/models/encoder-decoder.waymark"), WAYMARK_DATA_FOLDER);
  static Server server({.host = "127.0.0.1", .port = 8321}, api);
  TextChannel channel(request);
  server.serve(channel);
  const std::string& said = channel.answer();
  const std::size_t end = said.find("\r\n\r\n");
  if (end == std::string::npos) return {};
  return {std::stoi(said.substr(said.find(' '))), said.substr(0, end), said.substr(end + 4)};
}

const std::string host = "Host: 127.0.0.1:8321\r\n";

std::string get(const std::string& fields, const std::string& path = "/") {
  return "GET " + path + " HTTP/1.1\r\n" + fields + "\r\n";
}

std::string post(const std::string& fields, const std::string& body) {
  return "POST /api/formula HTTP/1.1\r\n" + host + "Content-Type: application/json\r\n" + fields + "\r\n" + body;
}

TEST(Serve, AnswersPageAndApi) {
  const Answer page = answer(get(host + "Accept-Encoding: gzip, br\r\n"));
  EXPECT_EQ(page.status, 200);
  EXPECT_NE(page.body.find("waymark studio"), std::string::npos);
  EXPECT_NE(page.head.find("Content-Length: " + std::to_string(page.body.size())), std::string::npos) << page.head;
  EXPECT_EQ(json::parse(answer(get(host, "/api/maps")).body)["maps"], (json{"grid", "jelly", "l"}));
  const Answer formula = answer(post("Content-Length: 21\r\n", R"({"formula": "F sofa"})"));
  EXPECT_EQ(formula.status, 200);
  EXPECT_EQ(json::parse(formula.body)["formula"], "F sofa");
}

TEST(Serve, RefusesASecondField) {  // of those that the guard reads, whatever it says
  for (const char* second : {"Host: 127.0.0.1:8321\r\n", "Host: evil.example\r\n", "HOST: 127.0.0.1:8321\r\n"}) {
    for (const std::string& fields : {host + second, second + host, host + "Accept: */*\r\n" + second}) {
      const Answer refused = answer(get(fields));
      ASSERT_EQ(refused.status, 400) << fields;
      EXPECT_EQ(json::parse(refused.body)["error"]["kind"], "refused") << refused.body;
    }
  }
  for (const char* field :
       {"Origin: http://127.0.0.1:8321\r\n", "Sec-Fetch-Site: none\r\n", "Authorization: Bearer\r\n"})
    EXPECT_EQ(answer(get(host + field + field)).status, 400) << field;
  EXPECT_EQ(answer(post("Content-Type: text/plain\r\nContent-Length: 2\r\n", "{}")).status, 400);
  EXPECT_EQ(answer(get("")).status, 403) << "no Host at all";
  EXPECT_EQ(answer(get(host + "Accept: text/html\r\nAccept: text/plain\r\n")).status, 200) << "another field";
}

TEST(Serve, RefusesHeadsThatAreTooLarge) {
  std::string fields = host;
  while (fields.size() < most_head - 1'000) fields += "X: " + std::string(500, 'x') + "\r\n";
  EXPECT_EQ(answer(get(fields)).status, 200);
  const Answer refused = answer(get(fields + "X: " + std::string(2'000, 'x') + "\r\n"));
  EXPECT_EQ(refused.status, 431);
  EXPECT_EQ(json::parse(refused.body)["error"]["kind"], "too large");
  EXPECT_EQ(answer("GET /" + std::string(most_head, 'a')).status, 431);
}

TEST(Serve, RefusesBodiesWithoutALength) {
  EXPECT_EQ(answer(post("", R"({"formula": "F sofa"})")).status, 411);
  EXPECT_EQ(answer(post("Content-Length: 0\r\n", "")).status, 400);
}

TEST(Serve, RefusesPathsThatAreTooLong) {
  EXPECT_EQ(answer(get(host, "/" + std::string(200, 'a'))).status, 404);
  EXPECT_EQ(answer(get(host, "/" + std::string(5'000, 'a'))).status, 414);
  EXPECT_EQ(answer(get(host, "/api/" + std::string(20'000, 'a'))).status, 414);
}

TEST(Serve, RefusesChunksThatAreMostlyFraming) {
  const std::string chunked = "Transfer-Encoding: chunked\r\n";
  EXPECT_EQ(answer(post(chunked, "8\r\n{\"formul\r\nd\r\na\": \"F sofa\"}\r\n0\r\n\r\n")).status, 200);
  const Answer refused = answer(post(chunked, "1;" + std::string(4 * most_body, 'x') + "\r\n{\r\n0\r\n\r\n"));
  EXPECT_EQ(refused.status, 413);
  EXPECT_EQ(json::parse(refused.body)["error"]["kind"], "too large");
  std::string small;
  for (std::size_t i = 0; i < most_body; ++i) small += "1\r\n \r\n";
  EXPECT_EQ(answer(post(chunked, small)).status, 413);
}

TEST(Serve, SendsWholeAnswersOnly) {
  const Answer whole = answer(get(host)), part = answer(get(host + "Range: bytes=0-,0-,0-,0-,0-\r\n"));
  EXPECT_EQ(part.status, 200);
  EXPECT_EQ(part.body, whole.body);
}

TEST(Serve, RefusesHalfARequest) {
  const std::string whole = post("Content-Length: 21\r\n", R"({"formula": "F sofa"})");
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const int status = answer(whole.substr(0, size)).status;
    EXPECT_TRUE(status == 0 || status == 400) << size << ": " << status;
  }
}

}  // namespace
}  // namespace waymark::studio
