// Requests to the studio: the bytes of one, through the server and its guard to the API, without a socket. In the head,
// "Content-Length: *" stands for the length of what follows. Every answer is whole HTTP with the length that it says;
// what is no page is JSON, an error says its kind, and no request is answered by a defect.
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "libparser/model_file.hpp"
#include "tools/studio/server.hpp"

namespace {

using namespace waymark;

constexpr std::string_view end_of_head = "\r\n\r\n";

studio::Server& server() {
  static studio::Api api(parser::load_grounder(WAYMARK_DATA_FOLDER "/models/encoder-decoder.waymark"),
                         WAYMARK_DATA_FOLDER, 0.5);
  static studio::Server one({.host = "127.0.0.1", .port = 8321}, api);
  return one;
}

std::string with_length(std::string_view request) {
  const std::size_t head = request.find(end_of_head);
  constexpr std::string_view wanted = "Content-Length: *";
  const std::size_t at = request.substr(0, head).find(wanted);
  if (head == std::string_view::npos || at == std::string_view::npos) return std::string(request);
  const std::size_t star = at + wanted.size() - 1;
  return std::string(request.substr(0, star)) + std::to_string(request.size() - head - end_of_head.size()) +
         std::string(request.substr(star + 1));
}

void require(bool holds, const char* law, std::string_view answer) {
  if (holds) return;
  std::cerr << law << ":\n" << answer << "\n";
  std::abort();
}

std::size_t number_after(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  std::size_t value = SIZE_MAX;
  if (at != std::string_view::npos) std::from_chars(text.data() + at + key.size(), text.data() + text.size(), value);
  return value;
}

void examine(std::string_view answer, bool headers_only) {
  const std::size_t end = answer.find(end_of_head);
  require(end != std::string_view::npos, "an answer without an end of its head", answer);
  const std::string_view head = answer.substr(0, end), body = answer.substr(end + end_of_head.size());
  const std::size_t status = number_after(head, "HTTP/1.1 ");
  if (status == 100) return examine(body, headers_only);  // "Expect: 100-continue"
  require(status >= 200 && status < 600 && status != 500, "a defect", answer);
  require(headers_only || number_after(head, "Content-Length: ") == body.size(), "another length", answer);
  if (headers_only || head.find("Content-Type: application/json") == std::string_view::npos) return;
  const auto json = nlohmann::json::parse(body, nullptr, false);
  require(json.is_object(), "no JSON object", answer);
  require(json.contains("error") == (status != 200), "an error, or none", answer);
  if (status != 200) require(json["error"]["kind"].is_string(), "an error without a kind", answer);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4'096) return 0;
  const std::string request = with_length({reinterpret_cast<const char*>(data), size});
  studio::TextChannel channel(request);
  server().serve(channel);
  if (!channel.answer().empty()) examine(channel.answer(), request.starts_with("HEAD"));
  return 0;
}
