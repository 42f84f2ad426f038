// JSON written, not read: one compact object a line, keys in the order they are added.
#pragma once
#include <concepts>
#include <string>
#include <string_view>

namespace waymark::tools {

class Json {  // one value, as its text
 public:
  Json(std::string_view value);  // NOLINT(google-explicit-constructor): values read best without ceremony
  Json(const char* value) : Json(std::string_view(value)) {}                // NOLINT(google-explicit-constructor)
  Json(const std::string& value) : Json(std::string_view(value)) {}         // NOLINT(google-explicit-constructor)
  Json(std::same_as<bool> auto value) : text_(value ? "true" : "false") {}  // NOLINT(google-explicit-constructor)
  template <typename Integer>
  requires(std::integral<Integer> && !std::same_as<Integer, bool>) Json(Integer value)
      : text_(std::to_string(value)) {}  // NOLINT(google-explicit-constructor)
  Json(double value);  // NOLINT(google-explicit-constructor): shortest text that reads back; infinity is "inf"
  Json() : text_("null") {}
  const std::string& text() const { return text_; }

 protected:
  struct Verbatim {};
  Json(Verbatim, std::string text) : text_(std::move(text)) {}
  std::string text_;
};

class JsonObject : public Json {
 public:
  JsonObject() : Json(Verbatim{}, "{}") {}
  JsonObject& add(std::string_view key, const Json& value);
};

class JsonArray : public Json {
 public:
  JsonArray() : Json(Verbatim{}, "[]") {}
  JsonArray& add(const Json& value);
};

}  // namespace waymark::tools
