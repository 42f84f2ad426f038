#include "libparser/grounding/instruction.hpp"

#include <nlohmann/json.hpp>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

using nlohmann::json;

std::optional<std::string> start_of(const json& start) {
  if (start.is_string()) return start.get<std::string>();
  if (!start.is_array() || start.size() < 2 || start.size() > 3) return std::nullopt;
  std::string text;
  for (const json& value : start) {
    if (!value.is_number_integer()) return std::nullopt;
    text += (text.empty() ? "" : ",") + value.dump();
  }
  return text;
}

}  // namespace

Instruction parse_instruction(std::string_view line, std::string_view source, std::size_t number) {
  if (line.empty() || line.front() != '{') return {std::string(line), {}, {}, {}, {}};
  const auto fail = [&](const std::string& message) { throw ltl::FormatError(source, number, 0, message); };
  const json object = json::parse(line, nullptr, false);
  if (!object.is_object()) fail("is no JSON object, though it begins like one");
  Instruction out;
  const auto text = object.find("text");
  if (text == object.end() || !text->is_string()) fail("'text' must be there, and a string");
  out.text = text->get<std::string>();
  const auto name = [&](const char* key, std::optional<std::string>& value) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (!found->is_string()) fail("'" + std::string(key) + "' must be a string");
    value = found->get<std::string>();
  };
  name("map", out.map);
  name("id", out.id);
  name("domain", out.domain);
  if (const auto start = object.find("start"); start != object.end() && !start->is_null()) {
    out.start = start_of(*start);
    if (!out.start) fail("'start' must be [x,y], [x,y,heading] or a string of that");
  }
  return out;
}

}  // namespace waymark::parser
