#include "libplan/motion/read_motion.hpp"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>

#include "libplan/world/json_position.hpp"

namespace waymark::plan {
namespace {

using nlohmann::json;

class MotionReader {
 public:
  MotionReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  Motion read() const {
    const json document = parse();
    const json& line = member(document, "motion");
    if (!line.is_array()) fail("motion", "expected a list of configurations [x,y,heading]");
    Motion motion;
    for (std::size_t i = 0; i < line.size(); ++i)
      motion.configurations.push_back(configuration(line[i], "motion[" + std::to_string(i) + "]"));
    motion.robot = robot(document);
    return motion;
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw format_error(source_, text_, path, message);
  }

  json parse() const {
    try {
      return json::parse(text_.begin(), text_.end());
    } catch (const json::parse_error& error) {
      throw format_error_at(source_, text_, error.byte > 0 ? error.byte - 1 : 0, "malformed JSON");
    } catch (const json::out_of_range&) {
      throw ltl::FormatError(source_, 0, 0, "a number of the JSON text is out of range");
    }
  }

  Robot robot(const json& document) const {
    if (!document.contains("car")) return Disc{number(member(document, "radius"), "radius")};
    const json& car = document["car"];
    const auto part = [&](const char* key) {
      return number(member(car, key, "car"), std::string("car.") + key);
    };
    return Car{.length = part("length"), .width = part("width"), .turning_radius = part("turning_radius")};
  }

  const json& member(const json& document, const char* key, const char* path = "") const {
    if (!document.is_object() || !document.contains(key))
      fail(path, "expected an object with the key \"" + std::string(key) + "\"");
    return document[key];
  }

  double number(const json& value, const std::string& path) const {
    if (!value.is_number()) fail(path, "expected a number");
    return value.get<double>();
  }

  Configuration configuration(const json& value, const std::string& path) const {
    if (!value.is_array() || value.size() != 3) fail(path, "expected a configuration [x,y,heading]");
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = number(value[i], path + "[" + std::to_string(i) + "]");
    return {numbers[0], numbers[1], numbers[2]};
  }

  std::string_view text_, source_;
};

}  // namespace

Motion parse_motion(std::string_view json, std::string_view source) {
  return MotionReader(json, source).read();
}

Configuration parse_configuration(std::string_view text) {
  std::array<double, 3> values{0, 0, 0};
  const char *at = text.data(), *end = text.data() + text.size();
  std::size_t count = 0;
  bool goes_on = true;  // a number must follow
  while (goes_on && count < values.size()) {
    const auto [next, error] = std::from_chars(at, end, values.at(count));
    if (error != std::errc{}) break;
    ++count;
    goes_on = next != end && *next == ',';
    at = goes_on ? next + 1 : next;
  }
  const Configuration c{values[0], values[1], values[2]};
  if (count < 2 || goes_on || at != end || !is_configuration(c))
    throw ltl::FormatError(
        "start", 0, 0,
        "expected x,y or x,y,heading with 0 ≤ heading < 360, not \"" + std::string(text) + '"');
  return c;
}

}  // namespace waymark::plan
