#include "libparser/domain/streets/street_corpus.hpp"

#include <algorithm>

#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/token.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::streets {
namespace {

using json = plan::JsonReader::Value;

LandmarkIndex read_landmark(const plan::JsonReader& line, const json& value, const std::string& path,
                            const StreetMap& map) {
  const auto at = map.find(line.integer(value, path));
  if (!at) line.fail(path, "there is no landmark with that id on " + map.name);
  return *at;
}

StreetRoute read_path(const plan::JsonReader& line, const json& object, const StreetMap& map) {
  const json& list = line.member(object, "", "path");
  if (!list.is_array() || list.empty()) line.fail("path", "expected a list of landmarks");
  StreetRoute path;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = "path[" + std::to_string(i) + "]";
    path.push_back(read_landmark(line, list[i], at, map));
    if (i > 0 && !map.length(path[i - 1], path[i])) line.fail(at, "no way leads there from the landmark before");
  }
  return path;
}

StreetInstruction read_instruction(const plan::JsonReader& line, const std::vector<StreetMap>& maps) {
  const json object = line.parse();
  const auto text = [&](const char* key) { return line.string(line.member(object, "", key), key); };
  StreetInstruction instruction;
  instruction.id = text("id");
  instruction.text = text("text");
  const auto tokens = object.find("tokens");
  instruction.tokens = tokens == object.end() ? parser::tokenize(instruction.text) : line.strings(*tokens, "tokens");
  const std::string name = text("map");
  const auto map = std::find_if(maps.begin(), maps.end(), [&](const StreetMap& m) { return m.name == name; });
  if (map == maps.end()) line.fail("map", "there is no map called '" + name + "'");
  instruction.map = static_cast<std::size_t>(map - maps.begin());
  instruction.start = read_landmark(line, line.member(object, "", "start"), "start", *map);
  instruction.path = read_path(line, object, *map);
  if (instruction.path.front() != instruction.start) line.fail("path[0]", "expected the start");
  return instruction;
}

}  // namespace

std::vector<StreetInstruction> parse_street_instructions(std::string_view json_lines,
                                                         const std::vector<StreetMap>& maps, std::string_view source) {
  std::vector<StreetInstruction> instructions;
  parser::each_line(json_lines, [&](std::string_view text, std::size_t number) {
    instructions.push_back(read_instruction(plan::JsonReader(text, source, number), maps));
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
  for (const auto& map : parser::map_files(directory)) corpus.maps.push_back(read_street_map(map));
  corpus.instructions = parse_street_instructions(bytes, corpus.maps, file.string());
  return corpus;
}

}  // namespace waymark::streets
