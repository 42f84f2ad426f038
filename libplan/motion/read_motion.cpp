#include "libplan/motion/read_motion.hpp"

#include <array>
#include <charconv>
#include <string>

#include "libltl/diagnostic.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using Value = JsonReader::Value;

Configuration configuration(const JsonReader& in, const Value& value, const std::string& path) {
  if (!value.is_array() || value.size() != 3) in.fail(path, "expected a configuration [x,y,heading]");
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) numbers[i] = in.number(value[i], path + "[" + std::to_string(i) + "]");
  return {numbers[0], numbers[1], numbers[2]};
}

Robot robot(const JsonReader& in, const Value& document) {
  if (!document.contains("car")) return Disc{in.number(in.member(document, "", "radius"), "radius")};
  const auto part = [&](const char* key) {
    return in.number(in.member(document["car"], "car", key), std::string("car.") + key);
  };
  return Car{.length = part("length"), .width = part("width"), .turning_radius = part("turning_radius")};
}

}  // namespace

Motion parse_motion(std::string_view json, std::string_view source) {
  const JsonReader in(json, source);
  const Value document = in.parse();
  Motion motion;
  in.each(document, "", "motion", [&](const Value& value, const std::string& path) {
    motion.configurations.push_back(configuration(in, value, path));
  });
  motion.robot = robot(in, document);
  return motion;
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
    throw ltl::FormatError("", 0, 0,
                           "expected x,y or x,y,heading with 0 ≤ heading < 360, not \"" + std::string(text) + '"');
  return c;
}

}  // namespace waymark::plan
