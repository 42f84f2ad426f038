#include "libplan/world/json_reader.hpp"

#include <algorithm>
#include <cmath>

#include "libltl/text/foreign.hpp"
#include "libltl/vocabulary.hpp"
#include "libplan/world/json_position.hpp"

namespace waymark::plan {

JsonReader::Value JsonReader::parse() const {
  try {
    return Value::parse(text_.begin(), text_.end());
  } catch (const Value::parse_error& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error …": keep what follows the place.
    if (const std::string hint = ltl::foreign_hint(text_); !hint.empty())
      throw ltl::FormatError(source_, first_line_, 1, "expected JSON: " + hint);
    const std::string_view what = error.what();
    const std::size_t colon = what.find(": ");
    throw format_error_at(source_, text_, error.byte > 0 ? error.byte - 1 : 0,
                          "malformed JSON: " + std::string(what.substr(colon == what.npos ? 0 : colon + 2)),
                          first_line_);
  } catch (const Value::out_of_range&) {
    throw ltl::FormatError(source_, first_line_ > 1 ? first_line_ : 0, 0, "a number of the JSON text is out of range");
  }
}

void JsonReader::fail(const std::string& path, const std::string& message) const {
  throw format_error(source_, text_, path, message, first_line_);
}

void JsonReader::check_keys(const Value& object, const std::string& path, const std::vector<std::string>& known) const {
  const ltl::Vocabulary names(known);
  for (const auto& [key, value] : object.items()) {
    if (names.find(key)) continue;
    const auto meant = names.nearest(key);
    if (meant && !object.contains(*meant)) fail(path, "unknown key \"" + key + "\" (did you mean \"" + *meant + "\"?)");
  }
}

const JsonReader::Value& JsonReader::member(const Value& object, const std::string& path,
                                            const std::string& key) const {
  if (!object.is_object()) fail(path, "expected an object");
  if (!object.contains(key)) fail(path, "the key \"" + key + "\" is missing");
  return object[key];
}

const JsonReader::Value* JsonReader::find(const Value& object, const std::string& path, const std::string& key) const {
  if (!object.is_object()) fail(path, "expected an object");
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string JsonReader::string_or(const Value& object, const std::string& path, const std::string& key,
                                  const std::string& otherwise) const {
  const Value* const value = find(object, path, key);
  return value == nullptr ? otherwise : string(*value, path.empty() ? key : path + "." + key);
}

bool JsonReader::truth(const Value& value, const std::string& path) const {
  if (!value.is_boolean()) fail(path, "expected true or false");
  return value.get<bool>();
}

int JsonReader::integer(const Value& value, const std::string& path) const {
  if (!value.is_number_integer()) fail(path, "expected a whole number");
  const bool huge = value.is_number_unsigned() && value.get<std::uint64_t>() > INT32_MAX;
  const auto number = huge ? INT64_MAX : value.get<std::int64_t>();
  if (number < INT32_MIN || number > INT32_MAX) fail(path, "the number is too large");
  return static_cast<int>(number);
}

double JsonReader::number(const Value& value, const std::string& path) const {
  if (!value.is_number()) fail(path, "expected a number");
  const auto number = value.get<double>();
  if (!std::isfinite(number)) fail(path, "expected a finite number");
  return number;
}

std::string JsonReader::string(const Value& value, const std::string& path) const {
  if (!value.is_string()) fail(path, "expected a text");
  const auto controls = [](char c) {
    return (c >= 0 && c < ' ' && c != '\n' && c != '\t' && c != '\r') || c == '\x7F';
  };
  const auto& text = value.get_ref<const std::string&>();
  if (std::any_of(text.begin(), text.end(), controls)) fail(path, "expected a text without control characters");
  return text;
}

std::vector<std::string> JsonReader::strings(const Value& value, const std::string& path) const {
  if (!value.is_array()) fail(path, "expected a list of texts");
  std::vector<std::string> out;
  for (std::size_t i = 0; i < value.size(); ++i) out.push_back(string(value[i], path + "[" + std::to_string(i) + "]"));
  return out;
}

}  // namespace waymark::plan
