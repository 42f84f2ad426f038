#include "libparser/corpus/import/read_lines.hpp"

#include "libparser/corpus/corpus_file.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::parser {
namespace {

using json = plan::JsonReader::Value;

class LineReader {
 public:
  LineReader(std::string_view text, std::string_view file, std::size_t number)
      : in_(text, file, number), file_(file), number_(number) {}

  FlaggedParagraph read() const {
    const json object = in_.parse();
    FlaggedParagraph out;
    ReleasedParagraph& p = out.paragraph;
    p.id = in_.string(in_.member(object, "", "id"), "id");
    p.map = in_.string(in_.member(object, "", "map"), "map");
    p.text = in_.string(in_.member(object, "", "text"), "text");
    p.file = file_;
    p.line = number_;
    if (object.contains("num")) p.number = in_.integer(object["num"], "num");
    if (object.contains("start_place")) out.start_place = in_.integer(object["start_place"], "start_place");
    if (object.contains("goal")) p.goal = place(object["goal"], "goal");
    if (object.contains("path") && !object["path"].empty()) p.path = poses(object, "", "path");
    in_.each(object, "", "sentences", [&](const json& sentence, const std::string& path) {
      ReleasedSentence& s = p.sentences.emplace_back();
      s.id = in_.string(in_.member(sentence, path, "id"), path + ".id");
      s.text = in_.string(in_.member(sentence, path, "text"), path + ".text");
      s.trace.poses = poses(sentence, path, "path");
      s.file = file_;
      s.line = number_;
    });
    if (object.contains("flags"))
      in_.each(object, "", "flags", [&](const json& flag, const std::string& path) {
        out.flags.push_back(
            {std::string(file_), number_, in_.string(in_.member(flag, path, "kind"), path + ".kind"),
             p.id + ": " + (flag.contains("message") ? in_.string(flag["message"], path + ".message") : flag.dump())});
      });
    return out;
  }

 private:
  plan::Pose place(const json& value, const std::string& path) const {
    if (!value.is_array() || value.size() != 2) in_.fail(path, "expected a place [x, y]");
    return {in_.integer(value[0], path + "[0]"), in_.integer(value[1], path + "[1]"), 0};
  }

  std::vector<plan::Pose> poses(const json& object, const std::string& path, const char* key) const {
    std::vector<plan::Pose> out;
    in_.each(object, path, key, [&](const json& value, const std::string& at) {
      if (!value.is_array() || value.size() != 3) in_.fail(at, "expected a pose [x, y, heading]");
      out.push_back(
          {in_.integer(value[0], at + "[0]"), in_.integer(value[1], at + "[1]"), in_.integer(value[2], at + "[2]")});
    });
    return out;
  }

  plan::JsonReader in_;
  std::string_view file_;
  std::size_t number_;
};

}  // namespace

std::vector<FlaggedParagraph> parse_lines(std::string_view json_lines, std::string_view file) {
  std::vector<FlaggedParagraph> out;
  each_line(json_lines,
            [&](std::string_view line, std::size_t number) { out.push_back(LineReader(line, file, number).read()); });
  return out;
}

ReleasedMap released(const plan::Map& map) {
  ReleasedMap out;
  out.name = map.name();
  out.nodes = map.nodes();
  out.edges = map.edges();
  return out;
}

}  // namespace waymark::parser
