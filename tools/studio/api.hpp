// The API of the studio: a path and a body in, a status and a JSON object out. Nothing here knows of sockets.
//
// Every failure is an answer: {"error": {"kind", "message"}}, with the place of a syntax error in characters.
#pragma once
#include <atomic>
#include <stop_token>
#include <string>
#include <string_view>

#include "tools/studio/context.hpp"

namespace waymark::studio {

struct ApiAnswer {
  int status = 200;
  std::string json;
};

class Api {
 public:
  static constexpr double most_seconds = 10;    // of one request, unless told otherwise
  static constexpr int most_at_once = 8;        // requests; one more is turned away
  static constexpr int most_drawn_at_once = 3;  // among them, those for pictures, which leave places to the others

  Api(parser::Grounder reader, const std::filesystem::path& data, double seconds = most_seconds)
      : reader_(std::move(reader)), worlds_(data), seconds_(seconds) {}

  // method: "GET" or "POST". Thread-safe; never throws.
  ApiAnswer answer(std::string_view method, std::string_view path, std::string_view body, const std::stop_token& stop);

 private:
  ApiAnswer answer_within(std::string_view method, std::string_view path, std::string_view body,
                          const std::stop_token& stop);
  const parser::Grounder reader_;
  Worlds worlds_;
  const double seconds_;  // of one request
  std::atomic<int> at_once_ = 0, drawn_at_once_ = 0;
};

}  // namespace waymark::studio
