#include "libparser/streets/street_corpus.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/token.hpp"
#include "libplan/world/json_position.hpp"

namespace waymark::streets {
namespace {

using nlohmann::json;

struct Line {  // of the instruction file, while it is read
  std::string_view source, text;
  std::size_t number;

  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw ltl::FormatError(source, number, plan::offset_of(text, path) + 1, path + ": " + message);
  }
  const json& member(const json& object, const char* key) const {
    const auto at = object.find(key);
    if (at == object.end()) fail(key, "is missing");
    return *at;
  }
  std::string string(const json& object, const char* key) const {
    const json& value = member(object, key);
    if (!value.is_string()) fail(key, "expected a text");
    return value.get<std::string>();
  }
  LandmarkIndex landmark(const json& value, const std::string& path, const StreetMap& map) const {
    constexpr int limit = 1'000'000'000;
    if (!value.is_number_integer() || value < -limit || value > limit)
      fail(path, "expected the id of a landmark");
    const auto at = map.find(value.get<int>());
    if (!at) fail(path, "there is no landmark with that id on " + map.name);
    return *at;
  }
};

std::vector<std::string> read_tokens(const Line& line, const json& object, const std::string& text) {
  const auto tokens = object.find("tokens");
  if (tokens == object.end()) return parser::tokenize(text);
  const bool texts = tokens->is_array() &&
                     std::all_of(tokens->begin(), tokens->end(), [](const json& t) { return t.is_string(); });
  if (!texts) line.fail("tokens", "expected a list of words");
  return tokens->get<std::vector<std::string>>();
}

StreetRoute read_path(const Line& line, const json& object, const StreetMap& map) {
  const json& list = line.member(object, "path");
  if (!list.is_array() || list.empty()) line.fail("path", "expected a list of landmarks");
  StreetRoute path;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = "path[" + std::to_string(i) + "]";
    path.push_back(line.landmark(list[i], at, map));
    if (i > 0 && !map.length(path[i - 1], path[i]))
      line.fail(at, "no way leads there from the landmark before");
  }
  return path;
}

StreetInstruction read_instruction(const Line& line, const std::vector<StreetMap>& maps) {
  json object;
  try {
    object = json::parse(line.text);
  } catch (const json::parse_error& error) {
    throw ltl::FormatError(line.source, line.number, error.byte, "expected one JSON object on this line");
  } catch (const json::out_of_range&) {
    throw ltl::FormatError(line.source, line.number, 0, "a number of the JSON text is out of range");
  }
  if (!object.is_object())
    throw ltl::FormatError(line.source, line.number, 1, "expected one JSON object on this line");
  StreetInstruction instruction;
  instruction.id = line.string(object, "id");
  instruction.text = line.string(object, "text");
  instruction.tokens = read_tokens(line, object, instruction.text);
  const std::string name = line.string(object, "map");
  const auto map = std::find_if(maps.begin(), maps.end(), [&](const StreetMap& m) { return m.name == name; });
  if (map == maps.end()) line.fail("map", "there is no map called '" + name + "'");
  instruction.map = static_cast<std::size_t>(map - maps.begin());
  instruction.start = line.landmark(line.member(object, "start"), "start", *map);
  instruction.path = read_path(line, object, *map);
  if (instruction.path.front() != instruction.start) line.fail("path[0]", "expected the start");
  return instruction;
}

}  // namespace

std::vector<StreetInstruction> parse_street_instructions(std::string_view json_lines,
                                                         const std::vector<StreetMap>& maps,
                                                         std::string_view source) {
  std::vector<StreetInstruction> instructions;
  parser::each_line(json_lines, [&](std::string_view text, std::size_t number) {
    instructions.push_back(read_instruction({source, text, number}, maps));
  });
  return instructions;
}

bool is_street_corpus(const std::filesystem::path& directory) {
  const std::string bytes = parser::read_corpus_file(directory / "instructions.jsonl");
  const std::string_view text = bytes;
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const json first = json::parse(text.substr(begin, text.find('\n', begin) - begin), nullptr, false);
  return first.is_object() && first.contains("path") && !first.contains("sentences");
}

StreetCorpus read_street_corpus(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "instructions.jsonl";
  const std::string bytes = parser::read_corpus_file(file);
  StreetCorpus corpus;
  corpus.checksum = parser::fnv1a(bytes);
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(directory / "maps"))
    for (const auto& entry : std::filesystem::directory_iterator(directory / "maps"))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& map : files) corpus.maps.push_back(read_street_map(map));
  corpus.instructions = parse_street_instructions(bytes, corpus.maps, file.string());
  return corpus;
}

}  // namespace waymark::streets
