#include "libparser/corpus/sail_corpus.hpp"

#include <cstdlib>

#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/token.hpp"
#include "libplan/world/json_reader.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::parser {
namespace {

using json = plan::JsonReader::Value;

// One line of the file while it is read.
struct Line {
  plan::JsonReader reader;

  [[noreturn]] void fail(const std::string& path, const std::string& expected) const { reader.fail(path, expected); }

  const json& member(const json& object, const std::string& path, const char* key) const {
    return reader.member(object, path, key);
  }

  std::string string(const json& object, const std::string& path, const char* key) const {
    return reader.string(member(object, path, key), path.empty() ? key : path + "." + key);
  }

  int integer(const json& value, const std::string& path) const {
    constexpr int limit = 1'000'000;
    const int number = reader.integer(value, path);
    if (number < -limit || number > limit) fail(path, "expected a whole number between −1,000,000 and 1,000,000");
    return number;
  }

  plan::Pose pose(const json& value, const std::string& path) const {
    if (!value.is_array() || value.size() != 3) fail(path, "expected a pose [x, y, heading]");
    const plan::Pose pose{integer(value[0], path + "[0]"), integer(value[1], path + "[1]"),
                          integer(value[2], path + "[2]")};
    if (pose.heading < -1 || pose.heading > 270 || (pose.heading != -1 && pose.heading % 90 != 0))
      fail(path + "[2]", "expected a heading: 0, 90, 180, 270, or -1 for unknown");
    return pose;
  }

  std::vector<plan::Pose> trajectory(const json& list, const std::string& at) const {
    if (!list.is_array() || list.empty()) fail(at, "expected a list of poses");
    std::vector<plan::Pose> poses;
    for (std::size_t i = 0; i < list.size(); ++i) poses.push_back(pose(list[i], at + "[" + std::to_string(i) + "]"));
    return poses;
  }

  // A trajectory whose headings are all known and whose steps are single actions.
  std::vector<plan::Pose> steps(const json& list, const std::string& path) const {
    std::vector<plan::Pose> poses = trajectory(list, path);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const std::string at = path + "[" + std::to_string(i) + "]";
      if (poses[i].heading < 0) fail(at, "expected a known heading here");
      if (i == 0) continue;
      const plan::Pose &a = poses[i - 1], &b = poses[i];
      const int way = std::abs(a.x - b.x) + std::abs(a.y - b.y), turn = std::abs(a.heading - b.heading);
      if (!(way == 1 && turn == 0) && !(way == 0 && (turn == 90 || turn == 270)))
        fail(at, "expected one action after the pose before: a step of length 1 or a quarter turn");
    }
    return poses;
  }

  std::vector<plan::Pose> steps(const json& object, const std::string& path, const char* key) const {
    return steps(member(object, path, key), path + "." + key);
  }

  // None where the key is absent.
  std::vector<std::vector<plan::Pose>> paths(const json& object, const std::string& path, const char* key) const {
    std::vector<std::vector<plan::Pose>> out;
    const auto list = object.find(key);
    if (list == object.end()) return out;
    const std::string at = path + "." + key;
    if (!list->is_array()) fail(at, "expected a list of paths");
    for (std::size_t i = 0; i < list->size(); ++i) out.push_back(steps((*list)[i], at + "[" + std::to_string(i) + "]"));
    return out;
  }
};

Sentence read_sentence(const Line& line, const json& object, const std::string& path) {
  if (!object.is_object()) line.fail(path, "expected a sentence");
  Sentence sentence;
  sentence.id = line.string(object, path, "id");
  sentence.text = line.string(object, path, "text");
  if (const auto tokens = object.find("tokens"); tokens != object.end()) {
    sentence.tokens = line.reader.strings(*tokens, path + ".tokens");
  } else {
    sentence.tokens = tokenize(sentence.text);
  }
  if (object.contains("formula")) sentence.formula = line.string(object, path, "formula");
  sentence.heading_unknown = line.trajectory(line.member(object, path, "path"), path + ".path").front().heading < 0;
  sentence.absolute = line.steps(object, path, sentence.heading_unknown ? "path_north" : "path");
  sentence.relative = line.steps(object, path, sentence.heading_unknown ? "path_right90" : "path");
  sentence.also_good = line.paths(object, path, "also_good");
  sentence.refused = line.paths(object, path, "refused");
  return sentence;
}

Paragraph read_paragraph(const Line& line) {
  const json object = line.reader.parse();
  Paragraph paragraph;
  paragraph.id = line.string(object, "", "id");
  paragraph.map = line.string(object, "", "map");
  paragraph.text = line.string(object, "", "text");
  const json& sentences = line.member(object, "", "sentences");
  if (!sentences.is_array()) line.fail("sentences", "expected a list");
  for (std::size_t i = 0; i < sentences.size(); ++i)
    paragraph.sentences.push_back(read_sentence(line, sentences[i], "sentences[" + std::to_string(i) + "]"));
  return paragraph;
}

}  // namespace

std::vector<Paragraph> parse_sail_corpus(std::string_view json_lines, std::string_view source) {
  std::vector<Paragraph> paragraphs;
  each_line(json_lines, [&](std::string_view text, std::size_t number) {
    paragraphs.push_back(read_paragraph({plan::JsonReader(text, source, number)}));
  });
  return paragraphs;
}

Corpus read_sail_corpus(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "instructions.jsonl";
  const std::string bytes = read_corpus_file(file);
  Corpus corpus{parse_sail_corpus(bytes, file.string()), {}, fnv1a(bytes)};
  for (const auto& map : map_files(directory)) corpus.maps.push_back(plan::read_map(map.string(), ""));
  return corpus;
}

}  // namespace waymark::parser
